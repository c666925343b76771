// SPDX-License-Identifier: MIT
// The layer lists of the networks `field` and `classic` (trainer/README.md), of votes and of the front, with seeded initial weights.
#include "network/networks.hpp"

#include <string>

#include "data/sample_index.hpp"
#include "features/features.hpp"
#include "front/front_points.hpp"
#include "network/network_builder.hpp"
#include "sinew_formats/error.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

constexpr float kPriorWeight =
    static_cast<float>(kLogFeatureDivisor);  // of the log-rule channel: logit = log of the heat weight

class Builder : public NetworkBuilder {
 public:
  Builder(const std::string& architecture, uint32_t candidates, uint32_t grid, const InputShape& inputs, uint64_t seed)
      : NetworkBuilder(architecture, seed) {
    if (candidates < 1 || candidates > kMaxCandidates) {
      throw Error(architecture + ": candidates must be 1 to " + std::to_string(kMaxCandidates) + ", found " +
                  std::to_string(candidates));
    }
    network_.feature_set = kFeatureSet | inputs.feature_flags;
    network_.candidate_count = candidates;
    network_.grid_size = grid;
    vertex_input_ = all(add_buffer(Domain::kVertex, inputs.vertex_features));
    pair_input_ = all(add_buffer(Domain::kPair, inputs.pair_features));
  }
  // `layers` linear layers with ReLU, all as wide as the output.
  void perceptron(const Region& in, const Region& out, uint32_t layers) {
    Region state = in;
    for (uint32_t i = 1; i < layers; ++i) {
      const Region next = fresh(Domain::kVertex, out.channels);
      relu(state, next);
      state = next;
    }
    relu(state, out);
  }
  const Region& vertex_input() const { return vertex_input_; }
  const Region& pair_input() const { return pair_input_; }

 private:
  Region vertex_input_, pair_input_;
};

}  // namespace

FloatNetwork build_field(const FieldOptions& options, const InputShape& inputs, uint64_t seed) {
  Builder b("field", options.candidates, options.grid, inputs, seed);
  const uint32_t width = options.width;
  constexpr uint32_t kViews = 6;  // itself, ring mean, candidate max, part mean, its candidate max, character mean

  // A linear layer over concat(pair features, vertex embedding), written as two so that the vertex half runs once per
  // vertex.
  const Region embedding = b.fresh(Domain::kVertex, options.vertex_width);
  b.relu(b.vertex_input(), embedding);
  const Region vertex_half = b.fresh(Domain::kVertex, width);
  b.linear(embedding, vertex_half, 0, {}, 0.5);
  const Region spread = b.fresh(Domain::kPair, width);
  b.apply(LayerKind::kVertexToPair, vertex_half, spread);

  // Round r reads its concat buffer; channels [0, width) are the state that the layer before wrote there.
  const uint32_t views = options.rounds > 0 ? kViews : 2;
  uint16_t concat = b.add_buffer(Domain::kPair, views * width);
  Region state = b.part(concat, 0, width);
  b.linear(b.pair_input(), state, kLayerRelu | kLayerResidual, spread, 1.0);

  if (options.rounds == 0) {
    b.apply(LayerKind::kCandidateMax, state, b.part(concat, width, width));
    const Region next = b.fresh(Domain::kPair, width);
    b.linear(b.all(concat), next, kLayerRelu | kLayerResidual, state, 0.5);
    state = next;
  }
  for (uint32_t round = 0; round < options.rounds; ++round) {
    const Region part_mean = b.part(concat, 3 * width, width);
    b.apply(LayerKind::kRingMean, state, b.part(concat, width, width));
    b.apply(LayerKind::kCandidateMax, state, b.part(concat, 2 * width, width));
    b.apply(LayerKind::kPartMean, state, part_mean);
    b.apply(LayerKind::kCandidateMax, part_mean, b.part(concat, 4 * width, width));
    b.apply(LayerKind::kGlobalMean, state, b.part(concat, 5 * width, width));
    const bool last = round + 1 == options.rounds;
    const uint16_t next = b.add_buffer(Domain::kPair, last ? width : views * width);
    const Region next_state = b.part(next, 0, width);
    b.linear(b.all(concat), next_state, kLayerRelu | kLayerResidual, state, 0.5);
    concat = next;
    state = next_state;
  }

  // logit = prior(pair features) + correction(state); the prior starts as the heat binder, the correction near zero.
  const Region prior = b.fresh(Domain::kPair, 1);
  LinearParameters& prior_weights = b.linear(b.pair_input(), prior, 0, {}, 0.0);
  prior_weights.weights[inputs.log_rule] = kPriorWeight;
  const Region logits = b.fresh(Domain::kPair, 1);
  b.linear(state, logits, kLayerResidual, prior, 1e-4);
  return b.take();
}

FloatNetwork build_classic(uint32_t candidates, uint32_t grid, const InputShape& inputs, uint64_t seed,
                           uint32_t block_layers) {
  Builder b("classic", candidates, grid, inputs, seed);
  // Figure 7: attributes of the vertex and its distances to the K nearest joints -> MLP -> N x 64 first feature.
  const uint32_t attributes = inputs.vertex_features + inputs.pair_features * candidates;
  const uint16_t input = b.add_buffer(Domain::kVertex, attributes);
  b.apply(LayerKind::kCopy, b.vertex_input(), b.part(input, 0, inputs.vertex_features));
  b.apply(LayerKind::kPairToVertex, b.pair_input(),
          b.part(input, inputs.vertex_features, inputs.pair_features * candidates));
  const Region hidden = b.fresh(Domain::kVertex, 128);
  b.perceptron(b.all(input), hidden, block_layers);
  // A graph convolution is a linear layer over the vertex and the mean of its one-ring.
  const uint16_t first_ring = b.add_buffer(Domain::kVertex, 128);
  const Region first = b.part(first_ring, 0, 64);
  b.relu(hidden, first);
  b.apply(LayerKind::kRingMean, first, b.part(first_ring, 64, 64));

  // concat(graph pooling 256, sub-feature 256, first feature 64) = N x 576 second feature; its ring mean lies beside
  // it.
  const uint16_t second_ring = b.add_buffer(Domain::kVertex, 1152);
  const Region pooled = b.part(second_ring, 0, 256), sub = b.part(second_ring, 256, 256);
  const Region second = b.part(second_ring, 0, 576);
  b.relu(b.all(first_ring), sub);
  b.apply(LayerKind::kRingMax, sub, pooled);
  b.apply(LayerKind::kCopy, first, b.part(second_ring, 512, 64));

  // Figure 8: MLP + global max pool = global feature, handed to every vertex; two graph convolutions = local feature.
  const uint16_t merged = b.add_buffer(Domain::kVertex, 256 + 128);
  const Region deep = b.fresh(Domain::kVertex, 256);
  b.perceptron(second, deep, block_layers);
  b.apply(LayerKind::kGlobalMax, deep, b.part(merged, 0, 256));
  b.apply(LayerKind::kRingMean, second, b.part(second_ring, 576, 576));
  const uint16_t local_ring = b.add_buffer(Domain::kVertex, 512);
  const Region local = b.part(local_ring, 0, 256);
  b.relu(b.all(second_ring), local);
  b.apply(LayerKind::kRingMean, local, b.part(local_ring, 256, 256));
  b.relu(b.all(local_ring), b.part(merged, 256, 128));

  // concat -> MLP -> target feature -> softmax over the K slots.
  const Region target = b.fresh(Domain::kVertex, 256);
  b.perceptron(b.all(merged), target, block_layers);
  const Region scores = b.fresh(Domain::kVertex, candidates);
  b.linear(target, scores, 0, {}, 0.1);
  const Region logits = b.fresh(Domain::kPair, 1);
  b.apply(LayerKind::kVertexToSlots, scores, logits);
  return b.take();
}

FloatNetwork shrink_correction(const FloatNetwork& network, double strength, uint32_t log_rule) {
  FloatNetwork out = network;
  if (network.architecture != "field" || network.parameters.size() < 2) return out;
  const float s = static_cast<float>(strength);
  LinearParameters& correction = out.parameters[out.parameters.size() - 1];
  LinearParameters& prior = out.parameters[out.parameters.size() - 2];
  for (LinearParameters* p : {&correction, &prior}) {
    for (float& w : p->weights) w *= s;
    for (float& b : p->bias) b *= s;
  }
  prior.weights.at(log_rule) += (1 - s) * kPriorWeight;
  return out;
}

FloatNetwork make_field(const FieldOptions& options, uint64_t seed, uint32_t feature_flags) {
  return build_field(options, {vertex_channels(feature_flags), kPairFeatures, kPairLogRule, feature_flags}, seed);
}

FloatNetwork make_classic(uint32_t candidates, uint32_t grid, uint64_t seed, uint32_t feature_flags,
                          uint32_t block_layers) {
  const InputShape inputs{vertex_channels(feature_flags), pair_channels(feature_flags), kPairLogRule, feature_flags};
  return build_classic(candidates, grid, inputs, seed, block_layers);
}

namespace {

using namespace rigging;

class RigBuilder : public PointNetworkBuilder {
 public:
  RigBuilder(uint64_t seed, uint32_t feature_set)
      : PointNetworkBuilder("votes", seed, feature_set, kRigCells, "pnts") {}
  void far_max(const Region& in, const Region& out) {
    apply(LayerKind::kRingMax, in, out);
    network_.layers.back().flags = kLayerFar;
  }
};

}  // namespace

FloatNetwork make_rig_network(const RigNetworkOptions& options, uint64_t seed) {
  RigBuilder b(seed, options.hands ? kHandsFeatureSet : kRigFeatureSet);
  const auto width = static_cast<uint16_t>(options.width);
  const Region input = b.fresh(Domain::kVertex, kRigChannels);
  constexpr uint32_t kViews = 4;  // itself, near, far, all
  uint16_t views = b.add_buffer(Domain::kVertex, kViews * width);
  Region state = b.part(views, 0, width), skip = state;
  b.relu(input, state);
  for (uint32_t round = 0; round < options.rounds; ++round) {
    const Region message = b.fresh(Domain::kVertex, width);
    b.relu(state, message);
    b.apply(LayerKind::kRingMax, message, b.part(views, width, width));
    b.far_max(message, b.part(views, 2u * width, width));
    b.apply(LayerKind::kGlobalMax, message, b.part(views, 3u * width, width));
    const bool last = round + 1 == options.rounds;
    const uint16_t next = b.add_buffer(Domain::kVertex, kViews * width);
    const Region out = b.part(next, 0, width);
    if (round == 0) {
      b.relu(b.all(views), out);
    } else {
      b.linear(b.all(views), out, kLayerRelu | kLayerResidual, state, 0.7);
    }
    state = out;
    views = next;
    if (round == 1) skip = state;
    if (last) {
      b.apply(LayerKind::kCopy, skip, b.part(views, width, width));
      b.apply(LayerKind::kGlobalMax, state, b.part(views, 2u * width, width));
      b.apply(LayerKind::kGlobalMean, state, b.part(views, 3u * width, width));
    }
  }
  const Region wide = b.fresh(Domain::kVertex, 2u * width), narrow = b.fresh(Domain::kVertex, width);
  b.relu(b.all(views), wide);
  b.relu(wide, narrow);
  LinearParameters& last = b.linear(narrow, b.fresh(Domain::kVertex, kRigOutputs), 0, {}, 0.1);
  last.bias[kRigStartSpread] = last.bias[kRigEndSpread] = -3.5f;
  return b.take();
}

FloatNetwork make_front_network(const FrontNetworkOptions& options, uint64_t seed) {
  PointNetworkBuilder b("front", seed, rigging::kFrontFeatureSet, 0, "frnt");
  const uint32_t width = options.width;
  const Region input = b.fresh(Domain::kVertex, rigging::kFrontChannels);
  constexpr uint32_t kViews = 3;  // itself, largest, mean
  uint16_t views = b.add_buffer(Domain::kVertex, kViews * width);
  b.relu(input, b.part(views, 0, width));
  for (uint32_t round = 0; round < options.rounds; ++round) {
    const Region message = b.fresh(Domain::kVertex, width);
    b.relu(b.part(views, 0, width), message);
    b.apply(LayerKind::kGlobalMax, message, b.part(views, width, width));
    b.apply(LayerKind::kGlobalMean, message, b.part(views, 2 * width, width));
    const uint16_t next = b.add_buffer(Domain::kVertex, kViews * width);
    b.relu(b.all(views), b.part(next, 0, width));
    views = next;
  }
  const Region last = b.fresh(Domain::kVertex, width);
  b.relu(b.part(views, 0, width), last);
  b.linear(last, b.fresh(Domain::kVertex, rigging::kFrontOutputs), 0, {}, 0.3);
  return b.take();
}

}  // namespace sinew
