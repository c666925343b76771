// SPDX-License-Identifier: MIT
// The list of layers that a network is made of. The float trainer and the integer engine run the same list; the
// quantizer copies it into the model file. The engine knows these operations, not one architecture.
#ifndef SINEW_MODEL_LAYERS_HPP
#define SINEW_MODEL_LAYERS_HPP

#include <stdint.h>

namespace sinew {

// Rows of a buffer: one per welded vertex [U], or one per (vertex, candidate slot) [U x K]. Slots without a candidate
// are *absent*: their values are 0, and no operation counts them.
enum class Domain : uint8_t { kVertex = 0, kPair = 1 };

enum class LayerKind : uint8_t {
  kLinear = 1,    // out = act(W in + b [+ residual]), any domain, row by row
  kRingMean = 2,  // vertex: mean over one-ring neighbours (0 without any). pair: the same over the neighbours that have
                  // the same joint as candidate (0 when none has)
  kRingMax = 3,   // the same, largest value (0 when none)
  kPartMean = 4,  // pair: for (part, joint), sum over the pairs of the part's vertices with this joint, divided by the
                  // part's *vertex* count (absent = 0), handed back to every such pair. vertex: mean over the part
  kGlobalMean = 5,    // mean over all present rows, handed to every row
  kGlobalMax = 6,     // largest over all present rows, handed to every row
  kCandidateMax = 7,  // pair: largest over the present slots of the same vertex, handed to each of them
  kVertexToPair = 8,  // in: vertex buffer, out: pair buffer: every present slot gets its vertex' value
  kPairToVertex =
      9,  // in: pair buffer (c channels), out: vertex buffer (K x c channels): slots side by side, absent = 0
  kVertexToSlots =
      10,      // in: vertex buffer (K x c channels), out: pair buffer (c channels): the inverse of kPairToVertex
  kCopy = 11,  // same domain; places channels beside others (concat by placement)
};

constexpr uint8_t kLayerRelu = 1;      // kLinear: y = max(y, 0)
constexpr uint8_t kLayerResidual = 2;  // kLinear: adds the residual region before the activation

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

// Whether a layer of this kind may read `in_channels` of an `in` buffer and write `out_channels` of an `out` buffer, in
// a network for `candidates` slots. Regions inside their buffers, order and parameters are the caller's to check.
inline bool layer_fits(LayerKind kind, Domain in, Domain out, uint32_t in_channels, uint32_t out_channels,
                       uint32_t candidates) {
  switch (kind) {
    case LayerKind::kLinear:
      return in == out;
    case LayerKind::kRingMean:
    case LayerKind::kRingMax:
    case LayerKind::kPartMean:
    case LayerKind::kGlobalMean:
    case LayerKind::kGlobalMax:
    case LayerKind::kCopy:
      return in == out && in_channels == out_channels;
    case LayerKind::kCandidateMax:
      return in == Domain::kPair && out == Domain::kPair && in_channels == out_channels;
    case LayerKind::kVertexToPair:
      return in == Domain::kVertex && out == Domain::kPair && in_channels == out_channels;
    case LayerKind::kPairToVertex:
      return in == Domain::kPair && out == Domain::kVertex && in_channels * candidates == out_channels;
    case LayerKind::kVertexToSlots:
      return in == Domain::kVertex && out == Domain::kPair && in_channels == out_channels * candidates;
  }
  return false;
}

// Buffer 0 = vertex features [U x kVertexFeatures], buffer 1 = pair features [U x K x kPairFeatures], both inputs.
// The last layer writes the logits: a pair buffer, 1 channel; natural log units in the trainer, log2 units (Q10 int16)
// in the engine. A region may be written by one layer only, and only before it is read.
constexpr uint16_t kVertexInput = 0;
constexpr uint16_t kPairInput = 1;

constexpr uint32_t kMaxBuffers = 64;
constexpr uint32_t kMaxLayers = 128;
constexpr uint32_t kMaxChannels = 2048;

}  // namespace sinew
#endif
