// SPDX-License-Identifier: MIT
// The table of layer kinds, and the rules of layer lists that are read from it.
#include "model/layer_kinds.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "model/layer_list.hpp"

namespace sinew {
namespace {

TEST(LayerKinds, EveryKindHasARowAndANameOfItsOwn) {
  std::set<std::string> names;
  for (uint8_t number = 1; number <= kLayerKindCount; ++number) {
    const auto kind = static_cast<LayerKind>(number);
    EXPECT_TRUE(is_layer_kind(kind));
    EXPECT_EQ(traits_of(kind).kind, kind);
    names.insert(traits_of(kind).name);
  }
  EXPECT_EQ(names.size(), kLayerKindCount);
  EXPECT_FALSE(is_layer_kind(static_cast<LayerKind>(0)));
  EXPECT_FALSE(is_layer_kind(static_cast<LayerKind>(kLayerKindCount + 1)));
}

// Shapes of one layer from buffer 0 to 1, K = 3, and what the rules of layer lists say.
bool is_taken(LayerKind kind, Buffer in, Buffer out, uint8_t flags = 0, bool far = false) {
  const Buffer buffers[2] = {in, out};
  Layer layer;
  layer.kind = kind;
  layer.flags = flags;
  layer.in = {0, 0, in.channels};
  layer.out = {1, 0, out.channels};
  return find_layer_fault({buffers, &layer, 2, 1, 3, far}, 0) == LayerFault::kNone;
}

TEST(LayerKinds, ShapesAreThoseOfTheirRows) {
  const Buffer vertex = {Domain::kVertex, 4}, pair = {Domain::kPair, 4}, wide = {Domain::kVertex, 12};
  EXPECT_TRUE(is_taken(LayerKind::kLinear, vertex, wide));
  EXPECT_FALSE(is_taken(LayerKind::kLinear, vertex, pair));
  EXPECT_TRUE(is_taken(LayerKind::kRingMean, pair, pair));
  EXPECT_FALSE(is_taken(LayerKind::kRingMean, vertex, wide));
  EXPECT_TRUE(is_taken(LayerKind::kCandidateMax, pair, pair));
  EXPECT_FALSE(is_taken(LayerKind::kCandidateMax, vertex, vertex));
  EXPECT_TRUE(is_taken(LayerKind::kVertexToPair, vertex, pair));
  EXPECT_FALSE(is_taken(LayerKind::kVertexToPair, wide, pair));
  EXPECT_TRUE(is_taken(LayerKind::kPairToVertex, pair, wide));
  EXPECT_FALSE(is_taken(LayerKind::kPairToVertex, pair, vertex));
  EXPECT_TRUE(is_taken(LayerKind::kVertexToSlots, wide, pair));
  EXPECT_FALSE(is_taken(LayerKind::kVertexToSlots, vertex, pair));
  EXPECT_FALSE(is_taken(static_cast<LayerKind>(kLayerKindCount + 1), vertex, vertex));
}

TEST(LayerKinds, FlagsAreThoseOfTheirRowsAndFarNeighborsOfVerticesAlone) {
  const Buffer vertex = {Domain::kVertex, 4}, pair = {Domain::kPair, 4};
  EXPECT_TRUE(is_taken(LayerKind::kLinear, vertex, vertex, kLayerRelu));
  EXPECT_FALSE(is_taken(LayerKind::kCopy, vertex, vertex, kLayerRelu));
  EXPECT_TRUE(is_taken(LayerKind::kRingMax, vertex, vertex, kLayerFar, true));
  EXPECT_FALSE(is_taken(LayerKind::kRingMax, vertex, vertex, kLayerFar, false));
  EXPECT_FALSE(is_taken(LayerKind::kRingMax, pair, pair, kLayerFar, true));
  EXPECT_FALSE(is_taken(LayerKind::kLinear, vertex, vertex, kLayerFar, true));
}

}  // namespace
}  // namespace sinew
