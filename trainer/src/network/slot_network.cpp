// SPDX-License-Identifier: MIT
// The graph part is a layer list; the rows behind it, one of the mesh and one of every two slots, are Eigen's.
#include "network/slot_network.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "data/slot_sample.hpp"
#include "network/network_builder.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr uint32_t kHidden = 128;                        // of the first network
constexpr uint32_t kPairHidden = 64, kPairLast = 32;     // of the second
constexpr uint32_t kPairOffset = 4;                      // channels of d and |d|
constexpr uint32_t kPairOwn = kPairOffset + 2 * kSlots;  // those that are not the mesh's
enum HeadBlock : size_t { kJointHidden, kJointOut, kPairFirst, kPairSecond, kPairOut, kHeadBlocks };

class Builder : public NetworkBuilder {
 public:
  explicit Builder(uint64_t seed) : NetworkBuilder("slots", seed) {
    network_.task = kTaskRig;
    network_.feature_set = kSlotFeatureSet;
    network_.candidate_count = 1;
    network_.grid_size = 0;
    network_.input_names = {"vert"};
  }
};

size_t head_of(const FloatNetwork& network) { return network.parameters.size() - kHeadBlocks; }

template <class S>
using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
template <class S>
using Row = Eigen::Matrix<S, 1, Eigen::Dynamic>;

// A block as matrices: y = x W^T + b for rows x. Copies, because Eigen's sums may depend on alignment, and a resumed run has
// to give the same bytes.
template <class S>
struct Linear {
  Matrix<S> w;
  Row<S> b;
  Linear(const LinearParameters& shape, const LinearBlock<S>& block)
      : w(Eigen::Map<const Matrix<S>>(block.weights.data(), shape.out, shape.in)),
        b(Eigen::Map<const Row<S>>(block.bias.data(), shape.out)) {}
};
// Its gradient, in memory of its own for the same reason; add_to() it goes in the end.
template <class S>
struct LinearGradient {
  Matrix<S> w;
  Row<S> b;
  explicit LinearGradient(const LinearParameters& shape)
      : w(Matrix<S>::Zero(shape.out, shape.in)), b(Row<S>::Zero(shape.out)) {}
  void add_to(LinearBlock<S>* block) const {
    for (Eigen::Index i = 0; i < w.size(); ++i) block->weights[static_cast<size_t>(i)] += w.data()[i];
    for (Eigen::Index i = 0; i < b.size(); ++i) block->bias[static_cast<size_t>(i)] += b.data()[i];
  }
};

template <class S>
S sigmoid(S x) {
  return S(1) / (S(1) + std::exp(-x));
}

}  // namespace

FloatNetwork make_slot_network(const SlotNetworkOptions& options, uint64_t seed) {
  Builder b(seed);
  const auto channels_of = [&](uint32_t round) { return options.width << std::min(round, 2u); };
  uint32_t pooled_channels = 0;
  for (uint32_t round = 0; round < options.rounds; ++round) pooled_channels += channels_of(round);
  const Region input = b.fresh(Domain::kVertex, kSlotChannels);
  const uint16_t pooled = b.add_buffer(Domain::kVertex, pooled_channels);
  uint32_t offset = 0, in_channels = kSlotChannels;
  Region state = input;
  for (uint32_t round = 0; round < options.rounds; ++round) {
    const uint16_t views = b.add_buffer(Domain::kVertex, 2 * in_channels);
    b.apply(LayerKind::kCopy, state, b.part(views, 0, in_channels));
    b.apply(LayerKind::kRingMean, state, b.part(views, in_channels, in_channels));
    state = b.fresh(Domain::kVertex, channels_of(round));
    b.relu(b.all(views), state);
    b.apply(LayerKind::kGlobalMax, state, b.part(pooled, offset, channels_of(round)));
    offset += channels_of(round);
    in_channels = channels_of(round);
  }
  b.apply(LayerKind::kCopy, b.all(pooled), b.fresh(Domain::kVertex, pooled_channels));

  FloatNetwork network = b.take();
  Random random(mix_seeds(seed, 1));
  const auto add = [&](uint32_t in, uint32_t out, double gain, double fan_in) {
    LinearParameters block;
    block.in = in;
    block.out = out;
    block.bias.assign(out, 0.0f);
    block.weights.resize(size_t{in} * out);
    for (float& w : block.weights) w = static_cast<float>(gain * std::sqrt(2.0 / fan_in) * random.normal());
    network.parameters.push_back(std::move(block));
  };
  add(pooled_channels, kHidden, 1, pooled_channels);
  add(kHidden, kSlots * kSlotNumbers, 0.1, kHidden);
  add(kPairOwn + pooled_channels, kPairHidden, 1, pooled_channels);
  for (uint32_t o = 0; o < kPairHidden; ++o) {  // of these channels few are not 0
    for (uint32_t c = 0; c < kPairOwn; ++c)
      network.parameters.back().weights[size_t{o} * (kPairOwn + pooled_channels) + c] *=
          static_cast<float>(std::sqrt(pooled_channels / 8.0));
  }
  add(kPairHidden, kPairLast, 1, kPairHidden);
  add(kPairLast, 1, 0.3, kPairLast);
  return network;
}

void check_slot_network(const FloatNetwork& network, const std::string& source) {
  check_network(network, source);
  if (network.task != kTaskRig || network.architecture != "slots")
    throw Error(source + ": expected a network of slots, found " + network.architecture +
                (network.task == kTaskBind ? " for skin weights" : ""));
  uint32_t listed = 0;
  for (const Layer& layer : network.layers) listed += layer.kind == LayerKind::kLinear ? 1 : 0;
  const auto fail = [&](const std::string& what) { throw Error(source + ": damaged: " + what); };
  if (network.feature_set != kSlotFeatureSet || network.candidate_count != 1 || network.input_names.size() != 1 ||
      network.buffers[0].domain != Domain::kVertex || network.buffers[0].channels != kSlotChannels ||
      network.buffers[network.layers.back().out.buffer].domain != Domain::kVertex)
    fail("other inputs or outputs than a network of slots has");
  if (network.parameters.size() != listed + kHeadBlocks)
    fail(std::to_string(network.parameters.size()) + " weight blocks, expected " +
         std::to_string(listed + kHeadBlocks));
  const LinearParameters* const head = &network.parameters[head_of(network)];
  const uint32_t pooled = network.layers.back().out.channels;
  const bool fits = head[kJointHidden].in == pooled && head[kJointOut].in == head[kJointHidden].out &&
                    head[kJointOut].out == kSlots * kSlotNumbers && head[kPairFirst].in == kPairOwn + pooled &&
                    head[kPairSecond].in == head[kPairFirst].out && head[kPairOut].in == head[kPairSecond].out &&
                    head[kPairOut].out == 1;
  if (!fits) fail("the blocks behind the layer list do not fit together");
}

template <class S>
struct SlotRunner<S>::State {
  LayerRunner<S> graph;
  uint32_t vertices = 0;
  Row<S> pooled, hidden, joints, mask;  // mask: 0 where dropped, else what makes up for it
  Matrix<S> offsets;                    // [pairs x kPairOffset]
  Matrix<S> first, second, pairs;       // after the activation
  std::vector<S> outputs, d_graph;
};

template <class S>
SlotRunner<S>::SlotRunner() : state_(std::make_unique<State>()) {}
template <class S>
SlotRunner<S>::~SlotRunner() = default;
template <class S>
void SlotRunner<S>::set_team(Team* team) {
  state_->graph.set_team(team);
}

template <class S>
const std::vector<S>& SlotRunner<S>::forward(const FloatNetwork& shape, const std::vector<LinearBlock<S>>& parameters,
                                             const NetworkSample& sample, const DropoutOptions& dropout) {
  State& s = *state_;
  if (sample.vertices == 0) throw Error(sample.name + ": no vertices");
  const size_t head = head_of(shape);
  const auto block = [&](size_t i) { return Linear<S>(shape.parameters[head + i], parameters[head + i]); };
  DropoutOptions inputs_only = dropout;
  inputs_only.activations = 0;
  const std::vector<S>& rows = s.graph.forward(shape, parameters, sample, inputs_only);
  s.vertices = sample.vertices;
  s.pooled = Eigen::Map<const Row<S>>(rows.data(), static_cast<Eigen::Index>(rows.size() / s.vertices));

  const Linear<S> hidden = block(kJointHidden), out = block(kJointOut);
  s.mask = Row<S>::Ones(hidden.b.size());
  Random random(mix_seeds(dropout.seed, 3));
  for (Eigen::Index c = 0; c < s.mask.size() && dropout.activations > 0; ++c) {
    const bool drop = random.uniform() < static_cast<double>(dropout.activations);
    s.mask[c] = drop ? S(0) : S(1) / (S(1) - static_cast<S>(dropout.activations));
  }
  s.hidden = (s.pooled * hidden.w.transpose() + hidden.b).cwiseMax(S(0)).cwiseProduct(s.mask);
  s.joints = s.hidden * out.w.transpose() + out.b;
  for (uint32_t i = 0; i < kSlots; ++i) {
    S& presence = s.joints[i * kSlotNumbers + kSlotPresence];
    presence = sigmoid(presence);
  }

  const Linear<S> first = block(kPairFirst), second = block(kPairSecond), last = block(kPairOut);
  const Row<S> of_mesh = s.pooled * first.w.rightCols(s.pooled.size()).transpose() + first.b;
  s.offsets.resize(kSlotPairs, kPairOffset);
  s.first.resize(kSlotPairs, first.b.size());
  for (uint32_t i = 0; i < kSlots; ++i) {
    for (uint32_t j = i + 1; j < kSlots; ++j) {
      const uint32_t pair = slot_pair(i, j);
      S squared = S(1e-8);  // the root has no slope at 0
      for (uint32_t c = 0; c < 3; ++c) {
        const S d = s.joints[j * kSlotNumbers + c] - s.joints[i * kSlotNumbers + c];
        s.offsets(pair, c) = d;
        squared += d * d;
      }
      s.offsets(pair, 3) = std::sqrt(squared);
      s.first.row(pair) = of_mesh + (first.w.col(kPairOffset + i) + first.w.col(kPairOffset + kSlots + j)).transpose();
    }
  }
  s.first.noalias() += s.offsets * first.w.leftCols(kPairOffset).transpose();
  s.first = s.first.cwiseMax(S(0)).eval();
  s.second = ((s.first * second.w.transpose()).rowwise() + second.b).cwiseMax(S(0));
  s.pairs = (s.second * last.w.transpose()).rowwise() + last.b;
  for (uint32_t pair = 0; pair < kSlotPairs; ++pair) s.pairs(pair, 0) = sigmoid(s.pairs(pair, 0));

  s.outputs.assign(s.joints.data(), s.joints.data() + s.joints.size());
  s.outputs.insert(s.outputs.end(), s.pairs.data(), s.pairs.data() + kSlotPairs);
  return s.outputs;
}

template <class S>
void SlotRunner<S>::backward(const FloatNetwork& shape, const std::vector<LinearBlock<S>>& parameters,
                             const std::vector<S>& d_outputs, std::vector<LinearBlock<S>>* gradients) {
  State& s = *state_;
  const size_t head = head_of(shape);
  const auto block = [&](size_t i) { return Linear<S>(shape.parameters[head + i], parameters[head + i]); };
  std::vector<LinearGradient<S>> to;
  for (size_t i = 0; i < kHeadBlocks; ++i) to.emplace_back(shape.parameters[head + i]);
  // Back through y = x W^T + b with a row for every pair.
  const auto step_back = [&](size_t i, const Matrix<S>& x, const Matrix<S>& d) {
    to[i].w.noalias() += d.transpose() * x;
    to[i].b += d.colwise().sum();
  };

  Matrix<S> d_pairs(kSlotPairs, 1);
  for (uint32_t pair = 0; pair < kSlotPairs; ++pair) {
    const S p = s.pairs(pair, 0);
    d_pairs(pair, 0) = d_outputs[kSlots * kSlotNumbers + pair] * p * (S(1) - p);
  }
  step_back(kPairOut, s.second, d_pairs);
  const Matrix<S> d_second =
      (d_pairs * block(kPairOut).w).cwiseProduct((s.second.array() > S(0)).matrix().template cast<S>());
  step_back(kPairSecond, s.first, d_second);
  const Matrix<S> d_first =
      (d_second * block(kPairSecond).w).cwiseProduct((s.first.array() > S(0)).matrix().template cast<S>());
  const Linear<S> first = block(kPairFirst);
  LinearGradient<S>& to_first = to[kPairFirst];
  to_first.w.leftCols(kPairOffset).noalias() += d_first.transpose() * s.offsets;
  const Row<S> d_mesh = d_first.colwise().sum();
  to_first.b += d_mesh;
  to_first.w.rightCols(s.pooled.size()).noalias() += d_mesh.transpose() * s.pooled;
  Row<S> d_pooled = d_mesh * first.w.rightCols(s.pooled.size());
  const Matrix<S> d_offsets = d_first * first.w.leftCols(kPairOffset);

  Row<S> d_joints = Eigen::Map<const Row<S>>(d_outputs.data(), s.joints.size());
  for (uint32_t i = 0; i < kSlots; ++i) {
    const S p = s.joints[i * kSlotNumbers + kSlotPresence];
    d_joints[i * kSlotNumbers + kSlotPresence] *= p * (S(1) - p);
    for (uint32_t j = i + 1; j < kSlots; ++j) {
      const uint32_t pair = slot_pair(i, j);
      to_first.w.col(kPairOffset + i) += d_first.row(pair).transpose();
      to_first.w.col(kPairOffset + kSlots + j) += d_first.row(pair).transpose();
      for (uint32_t c = 0; c < 3; ++c) {
        const S d = d_offsets(pair, c) + d_offsets(pair, 3) * s.offsets(pair, c) / s.offsets(pair, 3);
        d_joints[j * kSlotNumbers + c] += d;
        d_joints[i * kSlotNumbers + c] -= d;
      }
    }
  }
  LinearGradient<S>&to_out = to[kJointOut], &to_hidden = to[kJointHidden];
  to_out.w.noalias() += d_joints.transpose() * s.hidden;
  to_out.b += d_joints;
  const Row<S> d_hidden = (d_joints * block(kJointOut).w)
                              .cwiseProduct(s.mask)
                              .cwiseProduct((s.hidden.array() > S(0)).matrix().template cast<S>());
  to_hidden.w.noalias() += d_hidden.transpose() * s.pooled;
  to_hidden.b += d_hidden;
  d_pooled.noalias() += d_hidden * block(kJointHidden).w;

  for (size_t i = 0; i < kHeadBlocks; ++i) to[i].add_to(&(*gradients)[head + i]);

  // Every vertex has the same row; one of them carries the gradient.
  s.d_graph.assign(size_t{s.vertices} * static_cast<size_t>(s.pooled.size()), S(0));
  std::copy_n(d_pooled.data(), d_pooled.size(), s.d_graph.begin());
  s.graph.backward(shape, parameters, s.d_graph, gradients);
}

template class SlotRunner<float>;
template class SlotRunner<double>;

}  // namespace sinew
