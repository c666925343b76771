// SPDX-License-Identifier: MIT
// Converts predicted rows to edited rows and then to finished rows. Rows are written after the last step that can
// fail.
#include "weights/finish.hpp"

#include <string.h>

#include "weights/confidence.hpp"
#include "weights/influences.hpp"
#include "weights/users_say.hpp"

namespace sinew {
namespace {

constexpr uint32_t kRowPiece = 256;  // vertices that a lane takes at a time

// The weights of a vertex of the surface by the network or the heat field, in kRowSlots slots.
void surface_row(const Prediction& p, const RowOptions& options, uint32_t vertex, uint16_t* joints, uint32_t* weights) {
  if (p.logits == nullptr) return heat_row(p.heat, vertex, joints, weights);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    joints[i] = kNoJoint;
    weights[i] = 0;
  }
  const uint32_t k = p.candidates;
  for (uint32_t i = 0; i < k; ++i) joints[i] = p.joints[static_cast<size_t>(vertex) * k + i];
  const int16_t* const own = p.logits + static_cast<size_t>(vertex) * k;
  if (options.softness_percent == 100) {
    p.softmax(own, joints, k, kSmallestKept, weights);
  } else {
    int16_t softened[SINEW_MAX_CANDIDATES];
    soften_logits(own, joints, k, options.softness_percent, softened);
    p.softmax(softened, joints, k, kSmallestKept, weights);
  }
}

// The row of a vertex in a part that a joint owns.
void own_row(const Prediction& p, uint32_t vertex, uint16_t* joints, uint32_t* weights) {
  const uint16_t owner = p.owners == nullptr ? kNoJoint : p.owners[p.mesh.part[vertex]];
  if (owner == kNoJoint) return;
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    joints[i] = i == 0 ? owner : kNoJoint;
    weights[i] = i == 0 ? kWholeRow : 0;
  }
}

// The same from the prediction.
void predicted_row(const Prediction& p, const RowOptions& options, uint32_t vertex, uint16_t* joints,
                   uint32_t* weights) {
  full_row(
      p, vertex,
      [&](uint32_t v, uint16_t* row_joints, uint32_t* row_weights) {
        surface_row(p, options, v, row_joints, row_weights);
      },
      joints, weights);
  own_row(p, vertex, joints, weights);
}

// Rows of all vertices of the surface.
void predict_rows(const Prediction& p, const RowOptions& options, const Threads& threads, const Rows& out) {
  threads.ranges(p.surface.welded_count, kRowPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) surface_row(p, options, v, out.joints_of(v), out.weights_of(v));
  });
}

// Rows of all welded vertices from those of the surface, and of parts that a joint owns.
void fill_rows(const Prediction& p, const Threads& threads, const EditedRows& edited) {
  const auto row = [&](uint32_t v, uint16_t* joints, uint32_t* weights) {
    memcpy(joints, edited.surface.joints_of(v), kRowSlots * sizeof(uint16_t));
    memcpy(weights, edited.surface.weights_of(v), kRowSlots * sizeof(uint32_t));
  };
  threads.ranges(p.mesh.welded_count, kRowPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) {
      uint16_t* const joints = edited.rows.joints_of(v);
      uint32_t* const weights = edited.rows.weights_of(v);
      if (edited.surface.joints != edited.rows.joints) full_row(p, v, row, joints, weights);
      own_row(p, v, joints, weights);
    }
  });
}

// A finished row of a welded vertex. Of two partners the lower one's is finished and the other's is its mirror image,
// so that rounding and ties fall alike.
void finish_edited_row(const EditedRows& edited, uint32_t welded, uint32_t influence_count, uint32_t total,
                       uint16_t* joints, uint16_t* row) {
  const uint32_t partner = edited.symmetry.symmetric ? edited.symmetry.vertex[welded] : kNoPartner;
  const uint32_t source = partner < welded ? partner : welded;
  keep_largest(edited.rows.joints_of(source), edited.rows.weights_of(source), kRowSlots, influence_count, total, joints,
               row);
  if (source != welded) mirror_influences(edited.symmetry, influence_count, joints, row);
}

// How sure a predicted row [kRowSlots] is of its strongest joint, as in sinew_bind_outputs::confidence.
uint8_t confidence_of(const Prediction& p, const uint32_t* weights) {
  uint32_t largest = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) largest = weights[i] > largest ? weights[i] : largest;
  return calibrated_confidence(p.model, largest);
}

void write_range(const Prediction& p, const RowOptions& options, const EditedRows& edited, uint32_t begin, uint32_t end,
                 const sinew_bind_outputs& outputs) {
  uint8_t* const confidence = outputs.confidence;
  const uint32_t n = options.influence_count;
  const uint32_t total = options.weight_format == SINEW_WEIGHT_UNORM8 ? 255u : 65535u;
  for (uint32_t v = begin; v < end; ++v) {
    if (options.is_given(v)) {
      if (confidence != nullptr) confidence[v] = 255;
      continue;
    }
    const size_t first = static_cast<size_t>(v) * n;
    const uint32_t welded = p.mesh.vertex_to_welded[v];
    uint16_t predicted_joints[kRowSlots];
    uint32_t predicted[kRowSlots];
    if (!options.edits_rows() || confidence != nullptr) predicted_row(p, options, welded, predicted_joints, predicted);
    if (confidence != nullptr) confidence[v] = confidence_of(p, predicted);
    uint16_t row[SINEW_MAX_INFLUENCES];
    if (options.edits_rows()) {
      finish_edited_row(edited, welded, n, total, outputs.joint_indices + first, row);
    } else {
      keep_largest(predicted_joints, predicted, kRowSlots, n, total, outputs.joint_indices + first, row);
    }
    store_weights(row, n, options.weight_format, first, outputs.weights);
  }
}

uint32_t count_symmetric(const Mesh& mesh, const Symmetry& symmetry) {
  uint32_t count = 0;
  for (uint32_t v = 0; kHasExtras && v < mesh.vertex_count && symmetry.symmetric; ++v)
    count += symmetry.vertex[mesh.vertex_to_welded[v]] != kNoPartner ? 1 : 0;
  return count;
}

}  // namespace

bool EditedRows::allocate(Arena& arena, const Counts& counts, const RowOptions& options) {
  (void)rows.allocate(arena, counts);
  surface = rows;
  if (counts.may_reduce()) (void)surface.allocate(arena, counts.surface());
  (void)given.allocate(arena, counts);
  if (options.symmetric) (void)symmetry.allocate(arena, counts);
  if (options.asks()) (void)questions.allocate(arena, counts, options.question_count);
  return arena.ok();
}

sinew_status check_given_rows(const RowOptions& options, uint32_t vertices, uint32_t joint_count,
                              const uint16_t* joints, const void* weights) {
  if (options.locked == nullptr && options.hints == nullptr) return SINEW_OK;
  for (uint32_t v = 0; v < vertices; ++v) {
    if (!options.is_given(v)) continue;
    const size_t first = static_cast<size_t>(v) * options.influence_count;
    for (uint32_t i = 0; i < options.influence_count; ++i) {
      if (joints[first + i] >= joint_count) return SINEW_ERROR_RANGE;
    }
    if (options.hints == nullptr || options.hints[v] == 0) continue;
    uint32_t row[SINEW_MAX_INFLUENCES];
    if (!read_row(weights, options.weight_format, first, options.influence_count, row)) return SINEW_ERROR_RANGE;
  }
  return SINEW_OK;
}

sinew_status check_answers(const RowOptions& options, uint32_t vertices, const sinew_skeleton& skeleton) {
  for (uint32_t i = 0; i < options.answer_count; ++i) {
    const sinew_answer& answer = options.answers[i];
    if (answer.kind > SINEW_ANSWER_HOST || answer.alone > 1) return SINEW_ERROR_ARGUMENT;
    if (answer.vertex >= vertices) return SINEW_ERROR_RANGE;
    if (answer.kind == SINEW_ANSWER_RIGID && !may_get_weight(skeleton, answer.joint)) return SINEW_ERROR_RANGE;
  }
  return SINEW_OK;
}

sinew_status edit_rows(const Prediction& p, const RowOptions& options, const Counts& counts, const uint16_t* joints,
                       const void* weights, const Progress& progress, Arena& arena, EditedRows* edited) {
  if (!arena.measuring()) predict_rows(p, options, counts.threads, edited->surface);
  if (options.rigid_parts != SINEW_RIGID_PARTS_AUTO) {
    const sinew_status status = options.rigid_parts == SINEW_RIGID_PARTS_ALWAYS
                                    ? make_parts_rigid(p.surface, counts, arena, &edited->surface)
                                    : make_parts_soft(p.surface, p.heat, counts, arena, &edited->surface);
    if (status != SINEW_OK) return status;
  }
  if (!arena.measuring()) {
    fill_rows(p, counts.threads, *edited);
    gather_given_rows(p.mesh, options.locked, options.hints, joints, weights, options.weight_format,
                      options.influence_count, &edited->given);
  }
  if (options.asks()) {
    const sinew_status status = ask_and_answer(p, options.answers, options.answer_count, options.question_count,
                                               edited->given, counts, arena, &edited->rows, &edited->questions);
    if (status != SINEW_OK) return status;
  }
  Symmetry& symmetry = edited->symmetry;
  if (options.symmetric) {
    const sinew_status status = find_symmetry(p.mesh, p.skeleton, counts, arena, &symmetry);
    if (status != SINEW_OK) return status;
    if (symmetry.symmetric) mirror_given_rows(p.mesh, symmetry, &edited->given);
  }
  if (options.hints != nullptr) {
    const sinew_status status = steer_rows(p.mesh, p.skeleton, edited->given, counts, progress, arena, &edited->rows);
    if (status != SINEW_OK) return status;
  }
  if (symmetry.symmetric) mirror_rows(p.mesh, edited->given, options.influence_count, &edited->rows, &symmetry);
  return SINEW_OK;
}

void write_rows(const Prediction& p, const RowOptions& options, const EditedRows& edited, const Threads& threads,
                sinew_bind_outputs* outputs) {
  threads.ranges(p.mesh.vertex_count, kRowPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    write_range(p, options, edited, begin, end, *outputs);
  });
  outputs->symmetric_vertices = count_symmetric(p.mesh, edited.symmetry);
  if (options.asks()) write_questions(p.mesh, edited.questions, outputs);
}

}  // namespace sinew
