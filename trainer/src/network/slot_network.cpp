// SPDX-License-Identifier: MIT
// The graph part is a layer list; joints by attention and the rows of every two slots behind it are Eigen's.
#include "network/slot_network.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "data/slot_sample.hpp"
#include "network/network_builder.hpp"
#include "sinew_formats/error.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

constexpr uint32_t kPairHidden = 64, kPairLast = 32;  // of the second network
constexpr double kLog2 = 0.69314718055994531;         // attention is in log2
enum HeadBlock : size_t { kFirstBlock, kSecondBlock, kOutBlock, kHeadBlocks };

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

namespace {

// h = relu(L [h, mean of h over near points, largest h of far points])
Region convolve(PointNetworkBuilder* b, const Region& state, uint32_t channels, bool far) {
  const uint32_t in = state.channels, views = far ? 3 : 2;
  const uint16_t concat = b->add_buffer(Domain::kVertex, views * in);
  b->apply(LayerKind::kCopy, state, b->part(concat, 0, in));
  b->apply(LayerKind::kRingMean, state, b->part(concat, in, in));
  if (far) b->apply(LayerKind::kRingMax, state, b->part(concat, 2 * in, in), kLayerFar);
  const Region next = b->fresh(Domain::kVertex, channels);
  b->relu(b->all(concat), next);
  return next;
}

// Adds the layers of the first network's output for every point, in `out`.
void add_joint_layers(PointNetworkBuilder* b, const SlotNetworkOptions& options, const Region& input,
                      const Region& out) {
  const uint32_t width = options.width;
  const uint16_t pooled = b->add_buffer(Domain::kVertex, options.rounds * width);
  Region first, state = input;
  for (uint32_t round = 0; round < options.rounds; ++round) {
    state = convolve(b, state, width, true);
    if (round == 0) first = state;
    b->apply(LayerKind::kGlobalMax, state, b->part(pooled, round * width, width));
  }
  const Region body = b->fresh(Domain::kVertex, width);
  b->relu(b->all(pooled), body);
  const uint16_t all = b->add_buffer(Domain::kVertex, 3 * width + input.channels);
  b->apply(LayerKind::kCopy, first, b->part(all, 0, width));
  b->apply(LayerKind::kCopy, state, b->part(all, width, width));
  b->apply(LayerKind::kCopy, body, b->part(all, 2 * width, width));
  b->apply(LayerKind::kCopy, input, b->part(all, 3 * width, input.channels));
  const Region last = b->fresh(Domain::kVertex, 2 * width);
  b->relu(b->all(all), last);
  b->linear(last, out, 0, {}, 0.2);
}

// The mesh's row, by graph convolutions of its own.
void add_mesh_layers(PointNetworkBuilder* b, const SlotNetworkOptions& options, const Region& input,
                     const Region& out) {
  const uint32_t width = std::max(options.width / 2, 2u);
  const uint16_t pooled = b->add_buffer(Domain::kVertex, 2 * width);
  Region state = input;
  for (uint32_t round = 0; round < 2; ++round) {
    state = convolve(b, state, width, false);
    b->apply(LayerKind::kGlobalMax, state, b->part(pooled, round * width, width));
  }
  b->linear(b->all(pooled), out, 0, {}, 1);
}

}  // namespace

FloatNetwork make_slot_network(const SlotNetworkOptions& options, uint64_t seed) {
  PointNetworkBuilder b("slots", seed, kSlotsFeatureSet, 0, "pnts");
  const Region input = b.fresh(Domain::kVertex, kRigChannels);
  const uint16_t rows = b.add_buffer(Domain::kVertex, kSlotRow);
  add_joint_layers(&b, options, input, b.part(rows, 0, kMeshRow));
  add_mesh_layers(&b, options, input, b.part(rows, kMeshRow, kMeshChannels));
  b.apply(LayerKind::kVertexToSlots, b.all(rows), b.fresh(Domain::kPair, kSlotRow));

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
  add(kPairChannels, kPairHidden, 1, 8);  // of its channels few are not 0
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
  const Region& out = network.layers.back().out;
  if (network.feature_set != kSlotsFeatureSet || network.candidate_count != 1 || network.input_names.size() != 1 ||
      network.buffers[0].domain != Domain::kVertex || network.buffers[0].channels != kRigChannels ||
      network.buffers[out.buffer].domain != Domain::kPair || out.channels != kSlotRow)
    fail("other inputs or outputs than a network of slots has");
  if (network.parameters.size() != listed + kHeadBlocks)
    fail(std::to_string(network.parameters.size()) + " weight blocks, expected " +
         std::to_string(listed + kHeadBlocks));
  const LinearParameters* const head = &network.parameters[head_of(network)];
  const bool fits = head[kFirstBlock].in == kPairChannels && head[kSecondBlock].in == head[kFirstBlock].out &&
                    head[kOutBlock].in == head[kSecondBlock].out && head[kOutBlock].out == 1;
  if (!fits) fail("the blocks behind the layer list do not fit together");
}

FloatNetwork joint_network(const FloatNetwork& both) {
  FloatNetwork network = both;
  network.parameters.resize(head_of(both));
  return network;
}

FloatNetwork connection_network(const FloatNetwork& both) {
  FloatNetwork network;
  network.architecture = "connections";
  network.task = kTaskRig;
  network.feature_set = kConnectionsFeatureSet;
  network.candidate_count = 1;
  network.grid_size = 0;
  network.input_names = {"pair"};
  network.buffers = {{Domain::kVertex, static_cast<uint16_t>(kPairChannels)}};
  for (size_t i = 0; i < kHeadBlocks; ++i) {
    const LinearParameters& block = both.parameters[head_of(both) + i];
    network.buffers.push_back({Domain::kVertex, static_cast<uint16_t>(block.out)});
    Layer layer;
    layer.flags = i + 1 < kHeadBlocks ? kLayerRelu : 0;
    layer.in = {static_cast<uint16_t>(i), 0, static_cast<uint16_t>(block.in)};
    layer.out = {static_cast<uint16_t>(i + 1), 0, static_cast<uint16_t>(block.out)};
    layer.parameters = static_cast<uint32_t>(i);
    network.layers.push_back(layer);
    network.parameters.push_back(block);
  }
  return network;
}

template <class S>
struct SlotRunner<S>::State {
  LayerRunner<S> graph;
  uint32_t vertices = 0;
  Matrix<S> rows, points;          // [V x kSlotRow]; [V x 3]
  Matrix<S> attention;             // [V x kSlots]
  Matrix<S> joints, offsets;       // [kSlots x kSlotNumbers]; [kSlots x 3]
  Row<S> mesh;                     // [kMeshChannels], divided
  Matrix<S> between;               // [pairs x kPairFirst] channels of the offset vector
  Matrix<S> first, second, pairs;  // after the activation
  std::vector<S> outputs, d_graph;

  void read_points(const NetworkSample& sample);
  void point_joints();
  void connect(const Linear<S>& first_block, const Linear<S>& second_block, const Linear<S>& last_block);
  void point_back(const Matrix<S>& d_joints);
};

template <class S>
void SlotRunner<S>::State::read_points(const NetworkSample& sample) {
  points.resize(vertices, 3);
  for (uint32_t v = 0; v < vertices; ++v)
    for (uint32_t c = 0; c < 3; ++c)
      points(v, c) = static_cast<S>(sample.inputs[0].rows[size_t{v} * kRigChannels + kRigPosition + c]) /
                     static_cast<S>(kPositionSteps);
}

// joint = mean of (point + its offset) by attention; likewise the presence.
template <class S>
void SlotRunner<S>::State::point_joints() {
  attention.resize(vertices, kSlots);
  joints.resize(kSlots, kSlotNumbers);
  offsets.resize(kSlots, 3);
  for (uint32_t i = 0; i < kSlots; ++i) {
    const auto logits = rows.col(i * kSlotChannels + kSlotAttention).array();
    auto a = attention.col(i);
    a = ((logits - logits.maxCoeff()) * static_cast<S>(kLog2)).exp().matrix();
    a /= a.sum();
    S squared = S(1e-8);  // the root has no slope at 0
    for (uint32_t c = 0; c < 3; ++c) {
      const S offset = a.dot(rows.col(i * kSlotChannels + kSlotPointOffset + c)) / S(kRigOffsetScale);
      offsets(i, c) = offset;
      squared += offset * offset;
      joints(i, c) = a.dot(points.col(c)) + offset;
    }
    joints(i, kSlotOffset) = std::sqrt(squared);
    joints(i, kSlotPresence) = sigmoid<S>(a.dot(rows.col(i * kSlotChannels + kSlotLogit)));
  }
  mesh = rows.row(0).tail(kMeshChannels) / S(kMeshRowDivisor);
}

template <class S>
void SlotRunner<S>::State::connect(const Linear<S>& first_block, const Linear<S>& second_block,
                                   const Linear<S>& last_block) {
  const Row<S> of_mesh = mesh * first_block.w.rightCols(kMeshChannels).transpose() + first_block.b;
  between.resize(kSlotPairs, kPairFirst);
  first.resize(kSlotPairs, first_block.b.size());
  for (uint32_t i = 0; i < kSlots; ++i) {
    for (uint32_t j = i + 1; j < kSlots; ++j) {
      const uint32_t pair = slot_pair(i, j);
      S squared = S(1e-8);
      for (uint32_t c = 0; c < 3; ++c) {
        const S d = joints(j, c) - joints(i, c);
        between(pair, c) = d;
        squared += d * d;
      }
      between(pair, 3) = std::sqrt(squared);
      first.row(pair) = of_mesh + (first_block.w.col(kPairFirst + i) + first_block.w.col(kPairSecond + j)).transpose();
    }
  }
  first.noalias() += between * first_block.w.leftCols(kPairFirst).transpose();
  first = first.cwiseMax(S(0)).eval();
  second = ((first * second_block.w.transpose()).rowwise() + second_block.b).cwiseMax(S(0));
  pairs = (second * last_block.w.transpose()).rowwise() + last_block.b;
  for (uint32_t pair = 0; pair < kSlotPairs; ++pair) pairs(pair, 0) = sigmoid(pairs(pair, 0));
}

// Gradient of the rows, which d_graph gets: of joints as point_joints() made them.
template <class S>
void SlotRunner<S>::State::point_back(const Matrix<S>& d_joints) {
  Matrix<S> d_rows = Matrix<S>::Zero(vertices, kSlotRow);
  for (uint32_t i = 0; i < kSlots; ++i) {
    const auto a = attention.col(i);
    Eigen::Matrix<S, Eigen::Dynamic, 1> d_attention = Eigen::Matrix<S, Eigen::Dynamic, 1>::Zero(vertices);
    const S p = joints(i, kSlotPresence), d_logit = d_joints(i, kSlotPresence) * p * (S(1) - p);
    const uint32_t own = i * kSlotChannels;
    for (uint32_t c = 0; c < 3; ++c) {
      const S d_position = d_joints(i, c);
      const S d_offset = d_position + d_joints(i, kSlotOffset) * offsets(i, c) / joints(i, kSlotOffset);
      d_attention +=
          points.col(c) * d_position + rows.col(own + kSlotPointOffset + c) * (d_offset / S(kRigOffsetScale));
      d_rows.col(own + kSlotPointOffset + c) = a * (d_offset / S(kRigOffsetScale));
    }
    d_attention += rows.col(own + kSlotLogit) * d_logit;
    d_rows.col(own + kSlotLogit) = a * d_logit;
    d_rows.col(own + kSlotAttention) =
        (a.array() * (d_attention.array() - a.dot(d_attention)) * static_cast<S>(kLog2)).matrix();
  }
  d_graph.assign(d_rows.data(), d_rows.data() + d_rows.size());
}

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
  if (sample.vertices == 0) throw Error(sample.name + ": no points");
  const size_t head = head_of(shape);
  const auto block = [&](size_t i) { return Linear<S>(shape.parameters[head + i], parameters[head + i]); };
  const std::vector<S>& rows = s.graph.forward(shape, parameters, sample, dropout);
  s.vertices = sample.vertices;
  s.rows = Eigen::Map<const Matrix<S>>(rows.data(), s.vertices, kSlotRow);
  s.read_points(sample);
  s.point_joints();
  s.connect(block(kFirstBlock), block(kSecondBlock), block(kOutBlock));
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
  step_back(kOutBlock, s.second, d_pairs);
  const Matrix<S> d_second =
      (d_pairs * block(kOutBlock).w).cwiseProduct((s.second.array() > S(0)).matrix().template cast<S>());
  step_back(kSecondBlock, s.first, d_second);
  const Matrix<S> d_first =
      (d_second * block(kSecondBlock).w).cwiseProduct((s.first.array() > S(0)).matrix().template cast<S>());
  const Linear<S> first = block(kFirstBlock);
  LinearGradient<S>& to_first = to[kFirstBlock];
  to_first.w.leftCols(kPairFirst).noalias() += d_first.transpose() * s.between;
  const Row<S> d_mesh = d_first.colwise().sum();
  to_first.b += d_mesh;
  to_first.w.rightCols(kMeshChannels).noalias() += d_mesh.transpose() * s.mesh;
  const Matrix<S> d_between = d_first * first.w.leftCols(kPairFirst);
  Matrix<S> d_joints = Eigen::Map<const Matrix<S>>(d_outputs.data(), kSlots, kSlotNumbers);
  for (uint32_t i = 0; i < kSlots; ++i) {
    for (uint32_t j = i + 1; j < kSlots; ++j) {
      const uint32_t pair = slot_pair(i, j);
      to_first.w.col(kPairFirst + i) += d_first.row(pair).transpose();
      to_first.w.col(kPairSecond + j) += d_first.row(pair).transpose();
      for (uint32_t c = 0; c < 3; ++c) {
        const S d = d_between(pair, c) + d_between(pair, 3) * s.between(pair, c) / s.between(pair, 3);
        d_joints(j, c) += d;
        d_joints(i, c) -= d;
      }
    }
  }
  for (size_t i = 0; i < kHeadBlocks; ++i) to[i].add_to(&(*gradients)[head + i]);
  s.point_back(d_joints);
  // Every point has the same row of the mesh; one of them carries the gradient.
  const Row<S> d_row = d_mesh * first.w.rightCols(kMeshChannels) / S(kMeshRowDivisor);
  std::copy_n(d_row.data(), kMeshChannels, s.d_graph.begin() + kMeshRow);
  s.graph.backward(shape, parameters, s.d_graph, gradients);
}

template class SlotRunner<float>;
template class SlotRunner<double>;

}  // namespace sinew
