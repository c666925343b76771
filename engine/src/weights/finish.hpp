// SPDX-License-Identifier: MIT
// From predictions to the caller's rows (stage 9): predicted rows, rows that hints, symmetry and rigid parts changed,
// finished rows in the caller's order and format.
#ifndef SINEW_WEIGHTS_FINISH_HPP
#define SINEW_WEIGHTS_FINISH_HPP

#include "weights/prediction.hpp"
#include "weights/questions.hpp"
#include "weights/symmetry.hpp"

namespace sinew {

// The caller's options for the rows; see sinew_bind_options for each.
struct RowOptions {
  uint32_t influence_count = 4;  // slots of a row
  uint32_t weight_format = SINEW_WEIGHT_UNORM16;
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO;
  uint32_t softness_percent = 100;
  bool symmetric = false;
  const uint8_t* locked = nullptr;        // [V] or null
  const uint8_t* hints = nullptr;         // [V] or null
  const sinew_answer* answers = nullptr;  // [answer_count] or null
  uint32_t answer_count = 0;
  uint32_t question_count = 0;

  // Whether each part is processed on its own.
  bool asks() const { return kHasExtras && (answer_count > 0 || question_count > 0); }
  // Whether anything changes rows between prediction and influences. If so, edit_rows() must run before write_rows().
  bool edits_rows() const {
    return kHasExtras && (hints != nullptr || symmetric || rigid_parts != SINEW_RIGID_PARTS_AUTO || asks());
  }
  // Whether edit_rows() reads the heat field although the rows come from a network.
  bool reads_heat() const { return kHasExtras && (rigid_parts == SINEW_RIGID_PARTS_NEVER || asks()); }
  // Whether the caller gave the row of a vertex, which then stays as it is.
  bool is_given(uint32_t vertex) const {
    return (locked != nullptr && locked[vertex] != 0) || (hints != nullptr && hints[vertex] != 0);
  }
};

// Rows of which something was edited, in the workspace.
struct EditedRows {
  Rows surface;  // of the surface, where parts become rigid or soft; the same as `rows` if nothing can be reduced
  Rows rows;     // of the welded vertices
  GivenRows given;
  Symmetry symmetry;
  Questions questions;

  bool allocate(Arena& arena, const Counts& counts, const RowOptions& options);
};

// Checks the rows that the caller gave.
//   joints, weights  [V x influence_count] as the caller handed them to sinew_bind()
// Returns SINEW_OK, or SINEW_ERROR_RANGE where a given row has a joint >= joint_count, or a hint's weights are
// negative, not a number or all zero.
sinew_status check_given_rows(const RowOptions& options, uint32_t vertices, uint32_t joint_count,
                              const uint16_t* joints, const void* weights);

// Checks the answers that the caller gave: SINEW_OK, SINEW_ERROR_ARGUMENT for an unknown kind, or SINEW_ERROR_RANGE
// for a vertex or joint that does not exist, or a joint that the skeleton's flags forbid.
sinew_status check_answers(const RowOptions& options, uint32_t vertices, const sinew_skeleton& skeleton);

// Predicts the rows of all welded vertices and changes them as the options say. Only for options that edit rows.
//   joints, weights  [V x influence_count] the caller's; the rows that the caller gave are read
//   progress         reported from 0 to 1000 while hints are spread
//   arena            scratch, all of it released
//   edited           in/out allocated by the caller with the same counts and options
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status edit_rows(const Prediction& prediction, const RowOptions& options, const Counts& counts,
                       const uint16_t* joints, const void* weights, const Progress& progress, Arena& arena,
                       EditedRows* edited);

// Writes the rows of all vertices that the caller did not give, their confidence, how many vertices are symmetric, and
// what is worth asking.
//   edited   from edit_rows() with the same options; not read if nothing edits rows
//   outputs  in/out the caller's arrays [V x influence_count], in the caller's order and format
void write_rows(const Prediction& prediction, const RowOptions& options, const EditedRows& edited,
                const Threads& threads, sinew_bind_outputs* outputs);

}  // namespace sinew
#endif
