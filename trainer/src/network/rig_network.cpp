// SPDX-License-Identifier: MIT
// The layer lists of the networks of votes and of the front.
#include "network/rig_network.hpp"

#include "front/front_points.hpp"
#include "network/network_builder.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
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
