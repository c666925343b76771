// SPDX-License-Identifier: MIT
// Stage 8 of a bind: runs a model's layers on the features. Integers only; see DESIGN section 5 in formats/spec/model.md.
#ifndef SINEW_NETWORK_NETWORK_HPP
#define SINEW_NETWORK_NETWORK_HPP

#include "core/arena.hpp"
#include "core/counts.hpp"
#include "model/layers.hpp"
#include "sinew/sinew.h"

namespace sinew {

// What a network runs on, all borrowed. U welded vertices, K candidate slots.
struct NetworkInput {
  uint32_t vertex_count = 0;                // U
  uint32_t candidate_count = 0;             // K
  const int16_t* vertex_features = nullptr; // [U x C0] Q13
  const int16_t* pair_features = nullptr;   // [U x K x C1] Q13
  const uint16_t* joints = nullptr;         // [U x K], kNoJoint = absent
  const uint32_t* row_offsets = nullptr;    // [U + 1] one-ring CSR
  const uint32_t* col_indices = nullptr;
  const uint32_t* component = nullptr;      // [U]
  const uint32_t* component_offsets = nullptr;   // [components + 1]
  const uint32_t* component_vertices = nullptr;  // [U]
  uint32_t component_count = 0;
  uint32_t joint_count = 0;
};

// Runs all layers. logits out [U x K] int16, log2 units Q10; absent slots are 0 and mean nothing.
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status run_network(const sinew_model& model, const NetworkInput& input, const Progress& progress, Arena& arena,
                         int16_t* logits);
// Scratch run_network takes (released at its end), for the size query.
void measure_run_network(Arena& arena, const sinew_model& model, const Counts& counts);

}  // namespace sinew
#endif
