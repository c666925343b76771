// SPDX-License-Identifier: MIT
// The list of layers that a network is made of. The float trainer and the integer engine run the same list; the
// quantizer copies it into the model file. The engine knows these operations, not one architecture.
#ifndef SINEW_MODEL_LAYERS_HPP
#define SINEW_MODEL_LAYERS_HPP

#include <stdint.h>

#include "model/layer_kinds.hpp"

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
  uint32_t parameters = 0;  // of layers with weights: index of its weight block (0, 1, 2 ... in layer order)
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
