// SPDX-License-Identifier: MIT
// From predictions to the caller's rows (stage 9): predicted rows, rows that hints, symmetry and rigid parts changed,
// finished rows in the caller's order and format.
#ifndef SINEW_WEIGHTS_FINISH_HPP
#define SINEW_WEIGHTS_FINISH_HPP

#include "core/build.hpp"
#include "heat/heat.hpp"
#include "kernels/softmax.hpp"
#include "mesh/mesh.hpp"
#include "reduce/reduction.hpp"
#include "weights/rows.hpp"
#include "weights/symmetry.hpp"

namespace sinew {

// What the caller wants of the rows; see sinew_options for each.
struct RowOptions {
  uint32_t influence_count = 4;  // slots of a row
  uint32_t weight_format = SINEW_WEIGHT_UNORM16;
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO;
  uint32_t softness_percent = 100;
  bool symmetric = false;
  const uint8_t* locked = nullptr;  // [V] or null
  const uint8_t* hints = nullptr;   // [V] or null

  // Whether anything changes rows between prediction and influences. If so, edit_rows() must run before write_rows().
  bool edits_rows() const {
    return kHasExtras && (hints != nullptr || symmetric || rigid_parts != SINEW_RIGID_PARTS_AUTO);
  }
  // Whether edit_rows() reads the heat field although the rows come from a network.
  bool reads_heat() const { return kHasExtras && rigid_parts == SINEW_RIGID_PARTS_NEVER; }
  // Whether the caller gave the row of a vertex, which then stays as it is.
  bool is_given(uint32_t vertex) const {
    return (locked != nullptr && locked[vertex] != 0) || (hints != nullptr && hints[vertex] != 0);
  }
};

// What rows are predicted from: logits of a network, or else a heat field, for the vertices of the surface.
struct Prediction {
  const Mesh& mesh;            // the caller's, welded
  const Mesh& surface;         // the reduced mesh if there is one, else `mesh`
  const Reduction& reduction;  // from one to the other
  const Skeleton& skeleton;    // on the same grid
  const HeatField& heat;       // rows come from it if there are no logits
  const int16_t* logits;       // [U x K] log2 units Q10, or null
  const uint16_t* joints;      // [U x K] the joint of each logit
  uint32_t candidates;         // K
  SoftmaxKernel softmax;
  const sinew_model* model;          // the one that the logits are from, for its table of confidence; or null
  const uint16_t* owners = nullptr;  // [parts of mesh] the joint that is the row of the part's vertices, or kNoJoint
};

// Rows of which something was edited, in the workspace.
struct EditedRows {
  Rows surface;  // of the surface, where parts become rigid or soft; the same as `rows` if nothing can be reduced
  Rows rows;     // of the welded vertices
  GivenRows given;
  Symmetry symmetry;

  bool allocate(Arena& arena, const Counts& counts, const RowOptions& options);
};

// Checks the rows that the caller gave.
//   joints, weights  [V x influence_count] as the caller handed them to sinew_bind()
// Returns SINEW_OK, or SINEW_ERROR_RANGE where a given row has a joint >= joint_count, or a hint's weights are
// negative, not a number or all zero.
sinew_status check_given_rows(const RowOptions& options, uint32_t vertices, uint32_t joint_count,
                              const uint16_t* joints, const void* weights);

// Predicts the rows of all welded vertices and changes them as the options say. Only for options that edit rows.
//   joints, weights  [V x influence_count] the caller's; the rows that the caller gave are read
//   progress         reported from 0 to 1000 while hints are spread
//   arena            scratch, all of it released
//   edited           in/out allocated by the caller with the same counts and options
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status edit_rows(const Prediction& prediction, const RowOptions& options, const Counts& counts,
                       const uint16_t* joints, const void* weights, const Progress& progress, Arena& arena,
                       EditedRows* edited);

// Writes the rows of all vertices that the caller did not give, their confidence, and how many vertices are symmetric.
//   edited   from edit_rows() with the same options; not read if nothing edits rows
//   outputs  in/out the caller's arrays [V x influence_count], in the caller's order and format
void write_rows(const Prediction& prediction, const RowOptions& options, const EditedRows& edited,
                const Threads& threads, sinew_bind_outputs* outputs);

}  // namespace sinew
#endif
