// SPDX-License-Identifier: MIT
// Stage 8 of a bind: runs a model's layers on the features. Integers only; the arithmetic is defined in
// formats/spec/model.md.
#ifndef SINEW_NETWORK_NETWORK_HPP
#define SINEW_NETWORK_NETWORK_HPP

#include "core/arena.hpp"
#include "core/counts.hpp"
#include "kernels/table.hpp"
#include "model/layers.hpp"
#include "sinew/sinew.h"

namespace sinew {

// Input of a network, all borrowed. U vertices, K slots each; for a task over joints U joints, which the words
// vertex, pair and candidate then represent.
struct NetworkInput {
  uint32_t vertex_count = 0;     // U
  uint32_t candidate_count = 0;  // K
  // Rows of the task's inputs in its order, Q13: [U x C] or, in a domain with slots, [U x K x C].
  const int16_t* inputs[kMaxInputs] = {};
  const uint16_t* joints = nullptr;       // [U x K], kNoJoint = absent
  const uint32_t* row_offsets = nullptr;  // [U + 1] one-ring CSR
  const uint32_t* col_indices = nullptr;
  const uint32_t* far_offsets = nullptr;  // [U + 1] CSR of far neighbors, for tasks that have them
  const uint32_t* far_indices = nullptr;
  const uint32_t* part = nullptr;           // [U]
  const uint32_t* part_offsets = nullptr;   // [parts + 1]
  const uint32_t* part_vertices = nullptr;  // [U]
  uint32_t part_count = 0;
  uint32_t joint_count = 0;
  Threads threads = {};
};

// Vertices that go through a stage's layers together: with 8 candidates and some 600 channels their rows fill 150 KB.
constexpr uint32_t kTileVertices = 16;

struct NetworkOptions {
  bool weights_in_place = false;           // linear layers read the model's bytes, see sinew_bind_options
  uint32_t tile_vertices = kTileVertices;  // >= 1; changes scratch and speed, never the result
};

// Runs all layers of an opened model. input.candidate_count may be any K in 1..16, unless the model says
// fixed_candidates: then it is the model's. logits out: rows of the task's output, int16, clamped to +-32767; for bind
// [U x K] in log2 units, Q10. Rows of absent slots are 0 and mean nothing. Reports progress 0..1000 of its own work.
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED; scratch is released, logits are undefined on failure.
// Its memory in the arena is a function of the model, the options and the counts in `input`: the same for all kernels
// and everywhere.
sinew_status run_network(const sinew_model& model, const NetworkInput& input, const Kernels& kernels,
                         const Progress& progress, Arena& arena, int16_t* logits, const NetworkOptions& options = {});

}  // namespace sinew
#endif
