// SPDX-License-Identifier: MIT
// The layer list of the network of the front.
#include "network/front_network.hpp"

#include "front/front_points.hpp"
#include "network/network_builder.hpp"

namespace sinew {

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
