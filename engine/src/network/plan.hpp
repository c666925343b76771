// SPDX-License-Identifier: MIT
// How a model's layers are cut into stages: which layers run together tile by tile, which outputs must be stored for
// the whole mesh, and where. A function of the model alone.
#ifndef SINEW_NETWORK_PLAN_HPP
#define SINEW_NETWORK_PLAN_HPP

#include "model/layers.hpp"
#include "sinew/sinew.h"

namespace sinew {

// Inside a stage every vertex (with its candidate slots) can be computed from stored values and the vertex' own tile
// row, so a stage is one walk over the vertices in tiles. A layer that reads other rows (ring, part, global) needs its
// input finished by an earlier stage. An output is stored only when another stage or such a layer reads it; storage is
// shared by outputs whose lives do not overlap. About 7 KB; lives on the stack.
struct NetworkPlan {
  uint32_t candidates = 0;  // K
  uint32_t layer_count = 0, buffer_count = 0, stage_count = 0;
  uint32_t input_count = 0;  // buffers [0, input_count)
  Layer layers[kMaxLayers];
  Buffer buffers[kMaxBuffers];
  uint16_t stage[kMaxLayers];     // stage that computes the layer
  uint16_t last_use[kMaxLayers];  // last stage that reads its output
  bool stored[kMaxLayers];
  uint64_t store_offset[kMaxLayers];  // int16 values per vertex in front of it; its rows start at this times the vertex
                                      // count
  uint64_t store_values = 0;          // int16 values per vertex, all stored outputs together

  // Rows per vertex of a buffer: 1 or K.
  uint32_t slots(uint16_t buffer) const { return has_slots(buffers[buffer].domain) ? candidates : 1; }
};

// `candidates` is the K that it will run with.
void make_plan(const sinew_model& model, uint32_t candidates, NetworkPlan* plan);

}  // namespace sinew
#endif
