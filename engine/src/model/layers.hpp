// SPDX-License-Identifier: MIT
// The list of layers that a network is made of. The float trainer and the integer engine run the same list; the
// quantizer copies it into the model file. The engine knows these operations, not one architecture.
#ifndef SINEW_MODEL_LAYERS_HPP
#define SINEW_MODEL_LAYERS_HPP

#include <stdint.h>

namespace sinew {

// Rows of a buffer. A network runs over the vertices of a mesh or over the joints of a skeleton: U of them, one row each
// [U], or K slots each [U x K]. A slot of a vertex is a candidate joint, a slot of a joint another joint. Slots that hold
// nothing are *absent*: their values are 0, and no operation counts them. All buffers of a network are over the same.
enum class Domain : uint8_t { kVertex = 0, kPair = 1, kJoint = 2, kJointPair = 3 };
constexpr uint8_t kDomains = 4;
// Whether there is a row for every slot.
constexpr bool has_slots(Domain domain) { return (static_cast<uint8_t>(domain) & 1u) != 0; }
// The domain over the same vertices or joints with a row for every slot, and with one row for all of them.
constexpr Domain with_slots(Domain domain) { return static_cast<Domain>(static_cast<uint8_t>(domain) | 1u); }
constexpr Domain without_slots(Domain domain) { return static_cast<Domain>(static_cast<uint8_t>(domain) & ~1u); }

// "vertex" and "pair" below stand for a domain without slots and for the one with slots over the same.
enum class LayerKind : uint8_t {
  kLinear = 1,        // out = act(W in + b [+ residual]), any domain, row by row
  kRingMean = 2,      // vertex: mean over one-ring neighbours (0 without any).
                      // pair: the same over the neighbours that have the same joint in a slot (0 when none has)
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
  kCopy = 11,           // same domain; places channels beside others (concat by placement)
};

constexpr uint8_t kLayerRelu = 1;      // kLinear: y = max(y, 0)
constexpr uint8_t kLayerResidual = 2;  // kLinear: adds the residual region before the activation
constexpr uint8_t kLayerFar = 4;       // kRingMean, kRingMax, vertex: over the far neighbours, for tasks that have some

// Channels [offset, offset + channels) of a buffer.
struct Region {
  uint16_t buffer = 0;
  uint16_t offset = 0;
  uint16_t channels = 0;
};

struct Layer {
  LayerKind kind = LayerKind::kLinear;
  uint8_t flags = 0;
  Region in;
  Region out;
  Region residual;          // used with kLayerResidual; same shape as out
  uint32_t parameters = 0;  // kLinear: index of its weight block (0, 1, 2 ... in layer order)
};

struct Buffer {
  Domain domain = Domain::kVertex;
  uint16_t channels = 0;
};

// The first buffers are a network's inputs, which no layer writes. The last layer writes its output. A region may be
// written by one layer only, and only before it is read.
constexpr uint32_t kMaxInputs = 4;
constexpr uint32_t kMaxBuffers = 64;
constexpr uint32_t kMaxLayers = 128;
constexpr uint32_t kMaxChannels = 2048;

}  // namespace sinew
#endif
