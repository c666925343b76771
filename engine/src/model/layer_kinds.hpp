// SPDX-License-Identifier: MIT
// The kinds of layers, with one row per kind for everything but the arithmetic: reader, plan, executor, trainer,
// quantizer and reports. engine/README.md explains how to add one.
#ifndef SINEW_MODEL_LAYER_KINDS_HPP
#define SINEW_MODEL_LAYER_KINDS_HPP

#include <stdint.h>

namespace sinew {

// "vertex" and "pair" below represent a domain without slots and for the one with slots over the same (model/layers.hpp).
enum class LayerKind : uint8_t {
  kLinear = 1,        // out = act(W in + b [+ residual]), any domain, row by row
  kRingMean = 2,      // vertex: mean over one-ring neighbors (0 without any).
                      // pair: the same over the neighbors that have the same joint in a slot (0 when none has)
  kRingMax = 3,       // the same, largest value (0 when none)
  kPartMean = 4,      // vertex: mean over the part.
                      // pair: for (part, joint), sum over the pairs of the part's vertices with this joint, divided by
                      // the part's *vertex* count (absent = 0), handed back to every such pair
  kGlobalMean = 5,    // mean over all present rows, handed to every row
  kGlobalMax = 6,     // largest over all present rows, handed to every row
  kCandidateMax = 7,  // pair: largest over the present slots of the same vertex, handed to each of them
  kVertexToPair = 8,  // vertex -> pair: every present slot gets its vertex' value
  kPairToVertex = 9,  // pair (c channels) -> vertex (K x c channels): slots side by side, absent = 0
  kVertexToSlots = 10,  // vertex (K x c channels) -> pair (c channels): the inverse of kPairToVertex
  kCopy = 11,           // same domain; sets channels beside others (concatenation)
};

constexpr uint8_t kLayerRelu = 1;      // y = max(y, 0)
constexpr uint8_t kLayerResidual = 2;  // adds the residual region before the activation
constexpr uint8_t kLayerFar = 4;       // vertex: over the far neighbors, for tasks that have some

// How domain and channels of a layer's output follow from its input's.
enum class LayerShape : uint8_t {
  kWeights,    // same domain; channels as its weights have them
  kSame,       // same domain and channels
  kSameSlots,  // same domain, which has slots, and same channels
  kToSlots,    // vertex -> pair, same channels
  kJoinSlots,  // pair (c) -> vertex (K x c)
  kSplitSlots  // vertex (K x c) -> pair (c)
};

// The rows that a layer reads for one row of its output.
enum class LayerReads : uint8_t {
  kOwn,   // those of the same vertex
  kRing,  // those of neighbors
  kPart,  // all of the part: one row for each part, or for each of its joints
  kAll    // all: one row for the mesh
};

struct LayerTraits {
  LayerKind kind;
  char name[16];
  LayerShape shape;
  LayerReads reads;
  uint8_t flags;           // that it may have
  bool same_in_all_slots;  // all present slots of a vertex get the same values
  bool ends_network;       // it may write a network's output
};

constexpr uint8_t kLayerKindCount = 11;
// Row i is of kind i + 1.
inline constexpr LayerTraits kLayerTraits[kLayerKindCount] = {
    {LayerKind::kLinear, "linear", LayerShape::kWeights, LayerReads::kOwn, kLayerRelu | kLayerResidual, false, true},
    {LayerKind::kRingMean, "ring mean", LayerShape::kSame, LayerReads::kRing, kLayerFar, false, false},
    {LayerKind::kRingMax, "ring max", LayerShape::kSame, LayerReads::kRing, kLayerFar, false, false},
    {LayerKind::kPartMean, "part mean", LayerShape::kSame, LayerReads::kPart, 0, false, false},
    {LayerKind::kGlobalMean, "global mean", LayerShape::kSame, LayerReads::kAll, 0, true, false},
    {LayerKind::kGlobalMax, "global max", LayerShape::kSame, LayerReads::kAll, 0, true, false},
    {LayerKind::kCandidateMax, "candidate max", LayerShape::kSameSlots, LayerReads::kOwn, 0, true, false},
    {LayerKind::kVertexToPair, "vertex to pair", LayerShape::kToSlots, LayerReads::kOwn, 0, true, false},
    {LayerKind::kPairToVertex, "pair to vertex", LayerShape::kJoinSlots, LayerReads::kOwn, 0, false, false},
    {LayerKind::kVertexToSlots, "vertex to slots", LayerShape::kSplitSlots, LayerReads::kOwn, 0, false, true},
    {LayerKind::kCopy, "copy", LayerShape::kSame, LayerReads::kOwn, 0, false, false},
};

constexpr bool rows_in_order() {
  for (uint8_t i = 0; i < kLayerKindCount; ++i) {
    if (static_cast<uint8_t>(kLayerTraits[i].kind) != i + 1) return false;
  }
  return true;
}
static_assert(rows_in_order(), "row i of kLayerTraits is of kind i + 1");

constexpr bool is_layer_kind(LayerKind kind) {
  return static_cast<uint8_t>(kind) >= 1 && static_cast<uint8_t>(kind) <= kLayerKindCount;
}
// The row of a kind that is_layer_kind().
constexpr const LayerTraits& traits_of(LayerKind kind) { return kLayerTraits[static_cast<uint8_t>(kind) - 1]; }

constexpr bool has_weights(LayerKind kind) { return traits_of(kind).shape == LayerShape::kWeights; }
// Layers that read rows of other vertices than their own: their input must be finished for all of them.
constexpr bool reads_other_rows(LayerKind kind) { return traits_of(kind).reads != LayerReads::kOwn; }
// Layers whose rows come from a table of one row for each part or joint of it, or for the mesh.
constexpr bool uses_table(LayerKind kind) {
  return traits_of(kind).reads == LayerReads::kPart || traits_of(kind).reads == LayerReads::kAll;
}
constexpr bool by_part(LayerKind kind) { return traits_of(kind).reads == LayerReads::kPart; }
// Layers whose channels depend on K: their network runs with the K that it was made for.
constexpr bool fixes_candidates(LayerKind kind) {
  return traits_of(kind).shape == LayerShape::kJoinSlots || traits_of(kind).shape == LayerShape::kSplitSlots;
}

}  // namespace sinew
#endif
