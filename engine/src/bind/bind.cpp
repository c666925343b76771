// SPDX-License-Identifier: MIT
// Runs the stages, the network, and writes influences in the caller's order. Nothing is written before nothing can
// fail.
#include "bind/bind.hpp"

#include <string.h>

#include "core/build.hpp"
#include "kernels/select.hpp"
#include "model/task.hpp"
#include "weights/blend.hpp"
#include "weights/confidence.hpp"
#include "weights/given.hpp"
#include "weights/hints.hpp"
#include "weights/influences.hpp"
#include "weights/style.hpp"
#include "weights/symmetry.hpp"

namespace sinew {
namespace {

uint32_t or_default(uint32_t value, uint32_t fallback) { return value != 0 ? value : fallback; }

struct Logits {
  int16_t* values = nullptr;  // [U x K] log2 units, Q10
  SoftmaxKernel softmax = softmax_s16_ref;

  bool allocate(Arena& arena, const Counts& counts) {
    values = arena.alloc<int16_t>(static_cast<size_t>(counts.vertices) * counts.candidates);
    return arena.ok();
  }
};

// What the network or the heat field says of a vertex of p.surface(), in kRowSlots slots.
void surface_row(const BindPlan& plan, const Prepared& p, const Logits& logits, uint32_t vertex, uint16_t* joints,
                 uint32_t* weights) {
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    joints[i] = kNoJoint;
    weights[i] = 0;
  }
  if (plan.purpose == PrepareFor::kHeat) {
    uint16_t row_weights[kHeatSlots];
    const uint32_t count = finish_heat_row(p.heat.field[kFieldRule], vertex, joints, row_weights);
    for (uint32_t i = 0; i < count; ++i) weights[i] = 2u * row_weights[i];
    return;
  }
  const uint32_t k = plan.counts.candidates;
  for (uint32_t i = 0; i < k; ++i) joints[i] = p.features.joints[static_cast<size_t>(vertex) * k + i];
  const int16_t* const own = logits.values + static_cast<size_t>(vertex) * k;
  if (plan.softness_percent == 100) {
    logits.softmax(own, joints, k, kSmallestKept, weights);
  } else {
    int16_t softened[SINEW_MAX_CANDIDATES];
    soften_logits(own, joints, k, plan.softness_percent, softened);
    logits.softmax(softened, joints, k, kSmallestKept, weights);
  }
}

// The row of a welded vertex of the full mesh, from those that row(surface vertex, joints, weights) gives.
template <class Row>
void full_row(const Prepared& p, uint32_t vertex, const Row& row, uint16_t* joints, uint32_t* weights) {
  if (!kHasExtras || !p.reduction.active) return row(vertex, joints, weights);
  const Place place = p.reduction.place(p.mesh, vertex);
  RowBlend blend;
  for (int i = 0; i < 3; ++i) {
    if (place.shares[i] == 0) continue;
    row(place.vertices[i], joints, weights);
    blend.add(joints, weights, place.shares[i]);
  }
  blend.take(joints, weights);
}

// The same from the prediction.
void predicted_row(const BindPlan& plan, const Prepared& p, const Logits& logits, uint32_t vertex, uint16_t* joints,
                   uint32_t* weights) {
  full_row(
      p, vertex,
      [&](uint32_t v, uint16_t* row_joints, uint32_t* row_weights) {
        surface_row(plan, p, logits, v, row_joints, row_weights);
      },
      joints, weights);
}

// Rows that rigid parts, hints and symmetry change; not there without them.
struct Edit {
  Rows surface;  // of p.surface(), where parts become rigid or soft; the same as `rows` where nothing can be reduced
  Rows rows;
  GivenRows given;
  Symmetry symmetry;

  bool allocate(Arena& arena, const BindPlan& plan) {
    (void)rows.allocate(arena, plan.counts);
    surface = rows;
    if (plan.counts.may_reduce()) (void)surface.allocate(arena, plan.counts.surface());
    (void)given.allocate(arena, plan.counts);
    if (plan.symmetric) (void)symmetry.allocate(arena, plan.counts);
    return arena.ok();
  }
};

// What make_parts_soft() wants of the heat fields is all that is read of them behind the features.
PrepareFor stages_of(const BindPlan& plan) {
  const bool wants_heat = kHasExtras && plan.rigid_parts == SINEW_RIGID_PARTS_NEVER;
  return plan.purpose == PrepareFor::kNetwork && !wants_heat ? PrepareFor::kNetworkAlone : plan.purpose;
}

bool is_edited(const BindPlan& plan) {
  return kHasExtras && (plan.hints != nullptr || plan.symmetric || plan.rigid_parts != SINEW_RIGID_PARTS_AUTO);
}

constexpr uint32_t kVertexPiece = 256;  // vertices that a lane takes at a time

bool is_given(const BindPlan& plan, uint32_t vertex) {
  return (plan.locked != nullptr && plan.locked[vertex] != 0) || (plan.hints != nullptr && plan.hints[vertex] != 0);
}

sinew_status check_given(const BindPlan& plan, const uint16_t* joints, const void* weights, uint32_t joint_count) {
  if (plan.locked == nullptr && plan.hints == nullptr) return SINEW_OK;
  for (uint32_t v = 0; v < plan.counts.vertices; ++v) {
    if (!is_given(plan, v)) continue;
    const size_t first = static_cast<size_t>(v) * plan.influence_count;
    for (uint32_t i = 0; i < plan.influence_count; ++i) {
      if (joints[first + i] >= joint_count) return SINEW_ERROR_RANGE;
    }
    if (plan.hints == nullptr || plan.hints[v] == 0) continue;
    uint32_t row[SINEW_MAX_INFLUENCES];
    if (!read_row(weights, plan.weight_format, first, plan.influence_count, row)) return SINEW_ERROR_RANGE;
  }
  return SINEW_OK;
}

sinew_status edit_rows(const BindPlan& plan, const Prepared& p, const Logits& logits, const uint16_t* joints,
                       const void* weights, Arena& arena, Edit* edit) {
  Rows& surface = edit->surface;
  plan.counts.threads.ranges(p.surface().welded_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) surface_row(plan, p, logits, v, surface.joints_of(v), surface.weights_of(v));
  });
  if (plan.rigid_parts != SINEW_RIGID_PARTS_AUTO) {
    const sinew_status status =
        plan.rigid_parts == SINEW_RIGID_PARTS_ALWAYS
            ? make_parts_rigid(p.surface(), plan.counts, arena, &surface)
            : make_parts_soft(p.surface(), p.heat.field[kFieldRule], plan.counts, arena, &surface);
    if (status != SINEW_OK) return status;
  }
  if (surface.joints != edit->rows.joints) {
    const auto row = [&](uint32_t v, uint16_t* row_joints, uint32_t* row_weights) {
      memcpy(row_joints, surface.joints_of(v), kRowSlots * sizeof(uint16_t));
      memcpy(row_weights, surface.weights_of(v), kRowSlots * sizeof(uint32_t));
    };
    plan.counts.threads.ranges(p.mesh.welded_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
      for (uint32_t v = begin; v < end; ++v) full_row(p, v, row, edit->rows.joints_of(v), edit->rows.weights_of(v));
    });
  }
  gather_given_rows(p.mesh, plan.locked, plan.hints, joints, weights, plan.weight_format, plan.influence_count,
                    &edit->given);
  if (plan.symmetric) {
    const sinew_status status = find_symmetry(p.mesh, p.skeleton, plan.counts, arena, &edit->symmetry);
    if (status != SINEW_OK) return status;
    if (edit->symmetry.symmetric) mirror_given_rows(p.mesh, edit->symmetry, &edit->given);
  }
  if (plan.hints != nullptr) {
    const sinew_status status =
        steer_rows(p.mesh, p.skeleton, edit->given, plan.counts, plan.progress.part(960, 990), arena, &edit->rows);
    if (status != SINEW_OK) return status;
  }
  if (edit->symmetry.symmetric) mirror_rows(p.mesh, edit->given, plan.influence_count, &edit->rows, &edit->symmetry);
  return SINEW_OK;
}

// A finished row of a welded vertex. Of two partners the lower one's is finished and the other's is its mirror image,
// so that rounding and ties fall alike.
void finish_edited_row(const BindPlan& plan, const Edit& edit, uint32_t welded, uint32_t total, uint16_t* joints,
                       uint16_t* row) {
  const uint32_t n = plan.influence_count;
  const uint32_t partner = edit.symmetry.symmetric ? edit.symmetry.vertex[welded] : kNoPartner;
  const uint32_t source = partner < welded ? partner : welded;
  keep_largest(edit.rows.joints_of(source), edit.rows.weights_of(source), kRowSlots, n, total, joints, row);
  if (source != welded) mirror_influences(edit.symmetry, n, joints, row);
}

// How sure a predicted row [kRowSlots] is of its strongest joint, as in sinew_options::confidence.
uint8_t confidence_of(const BindPlan& plan, const uint32_t* weights) {
  uint32_t largest = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) largest = weights[i] > largest ? weights[i] : largest;
  return calibrated_confidence(plan.purpose == PrepareFor::kNetwork ? &plan.model : nullptr, largest);
}

void count_symmetric(const BindPlan& plan, const Prepared& p, const Edit& edit) {
  if (plan.symmetric_vertices == nullptr) return;
  *plan.symmetric_vertices = 0;
  for (uint32_t v = 0; kHasExtras && v < p.mesh.vertex_count && edit.symmetry.symmetric; ++v)
    *plan.symmetric_vertices += edit.symmetry.vertex[p.mesh.vertex_to_welded[v]] != kNoPartner ? 1 : 0;
}

void write_rows(const BindPlan& plan, const Prepared& p, const Logits& logits, const Edit& edit, uint32_t begin,
                uint32_t end, uint16_t* joints, void* weights) {
  const uint32_t n = plan.influence_count;
  const uint32_t total = plan.weight_format == SINEW_WEIGHT_UNORM8 ? 255u : 65535u;
  for (uint32_t v = begin; v < end; ++v) {
    if (is_given(plan, v)) {
      if (plan.confidence != nullptr) plan.confidence[v] = 255;
      continue;
    }
    const size_t first = static_cast<size_t>(v) * n;
    const uint32_t welded = p.mesh.vertex_to_welded[v];
    uint16_t predicted_joints[kRowSlots];
    uint32_t predicted[kRowSlots];
    if (!is_edited(plan) || plan.confidence != nullptr)
      predicted_row(plan, p, logits, welded, predicted_joints, predicted);
    if (plan.confidence != nullptr) plan.confidence[v] = confidence_of(plan, predicted);
    uint16_t row[SINEW_MAX_INFLUENCES];
    if (is_edited(plan)) {
      finish_edited_row(plan, edit, welded, total, joints + first, row);
    } else {
      keep_largest(predicted_joints, predicted, kRowSlots, n, total, joints + first, row);
    }
    for (uint32_t i = 0; i < n; ++i) {
      switch (plan.weight_format) {
        case SINEW_WEIGHT_UNORM8:
          static_cast<uint8_t*>(weights)[first + i] = static_cast<uint8_t>(row[i]);
          break;
        case SINEW_WEIGHT_UNORM16:
          static_cast<uint16_t*>(weights)[first + i] = row[i];
          break;
        // One correctly rounded IEEE division: the same on every target.
        default:
          static_cast<float*>(weights)[first + i] = static_cast<float>(row[i]) / 65535.0f;
          break;
      }
    }
  }
}

}  // namespace

sinew_status plan_bind(const sinew_model* model, uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints,
                       const sinew_options* options, BindPlan* plan) {
  const sinew_options defaults = {};
  const sinew_options& o = options != nullptr ? *options : defaults;
  if (o.version != 0 || o.symmetric > 1 || o.method > SINEW_METHOD_HEAT || o.influence_count > SINEW_MAX_INFLUENCES ||
      o.up_axis > 1 || o.weights_in_place > 1 || o.thread_count > SINEW_MAX_THREADS ||
      kernel_name(o.kernel) == nullptr || o.weight_format > SINEW_WEIGHT_FLOAT ||
      o.rigid_parts > SINEW_RIGID_PARTS_NEVER ||
      (o.surface_vertices != 0 && (o.surface_vertices < 16 || o.surface_vertices > SINEW_MAX_VERTICES)) ||
      (o.softness_percent != 0 && (o.softness_percent < 25 || o.softness_percent > 400))) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (!kHasExtras &&
      (o.hints != nullptr || o.symmetric != 0 || o.rigid_parts != SINEW_RIGID_PARTS_AUTO || o.surface_vertices != 0)) {
    return SINEW_ERROR_ARGUMENT;
  }
  plan->purpose = o.method == SINEW_METHOD_HEAT ? PrepareFor::kHeat : PrepareFor::kNetwork;
  uint32_t candidates = or_default(o.candidate_count, 8), grid = or_default(o.grid_size, 64);
  if (plan->purpose == PrepareFor::kNetwork) {
    if (model == nullptr || model->bytes == nullptr) return SINEW_ERROR_ARGUMENT;
    if (model->task != kTaskBind) return SINEW_ERROR_MODEL_TASK;
    plan->model = *model;
    candidates = or_default(o.candidate_count, model->candidate_count);
    grid = or_default(o.grid_size, model->grid_size);
    if (model->fixed_candidates != 0 && candidates != model->candidate_count) return SINEW_ERROR_ARGUMENT;
  }
  plan->influence_count = or_default(o.influence_count, 4);
  plan->up_axis = o.up_axis;
  plan->weight_format = o.weight_format;
  plan->locked = o.locked;
  plan->hints = o.hints;
  plan->symmetric = o.symmetric != 0;
  plan->network = NetworkOptions();
  plan->network.kernel = o.kernel;
  plan->network.weights_in_place = o.weights_in_place != 0;
  plan->rigid_parts = o.rigid_parts;
  plan->softness_percent = or_default(o.softness_percent, 100);
  plan->confidence = o.confidence;
  plan->symmetric_vertices = o.symmetric_vertices;
  plan->progress = Progress{o.progress, o.progress_user};
  const sinew_status status = make_counts(vertices, faces, corners, joints, candidates, grid, &plan->counts);
  if (plan->purpose == PrepareFor::kNetwork) plan->counts.feature_flags = model->feature_set & kFeatureFlags;
  plan->counts.surface_vertices = or_default(o.surface_vertices, kSurfaceVertices);
  plan->counts.threads = Threads{or_default(o.thread_count, 1), o.parallel_for, o.parallel_user};
  return status;
}

void measure_bind(Arena& arena, const BindPlan& plan) {
  measure_prepare(arena, plan.counts, stages_of(plan));
  if (plan.purpose == PrepareFor::kNetwork) {
    Logits().allocate(arena, plan.counts.surface());
    measure_run_network(arena, plan.model, plan.counts.surface(), plan.network);
  }
  if (!is_edited(plan)) return;
  Edit().allocate(arena, plan);
  if (plan.rigid_parts != SINEW_RIGID_PARTS_AUTO) measure_part_style(arena, plan.counts);
  if (plan.symmetric) measure_find_symmetry(arena, plan.counts);
  if (plan.hints != nullptr) measure_steer_rows(arena, plan.counts);
}

sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, uint16_t* joints, void* weights, size_t* used_bytes) {
  Kernels kernels;
  if (!select_kernels(plan.network.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  sinew_status status = check_given(plan, joints, weights, skeleton.joint_count);
  if (status != SINEW_OK) return status;
  Arena arena(workspace, workspace_bytes);
  Prepared p;
  status = prepare(mesh, skeleton, plan.up_axis, plan.counts, stages_of(plan), plan.progress, arena, &p,
                   plan.network.kernel);
  if (status != SINEW_OK) return status;

  Logits logits;
  logits.softmax = kernels.softmax;
  if (plan.purpose == PrepareFor::kNetwork) {
    if (!logits.allocate(arena, plan.counts.surface())) return SINEW_ERROR_WORKSPACE;
    const NetworkInput input = network_input(p, plan.counts);
    status = run_network(plan.model, input, plan.progress.part(650, is_edited(plan) ? 960 : 990), arena, logits.values,
                         plan.network);
    if (status != SINEW_OK) return status;
  }
  Edit edit;
  if (is_edited(plan)) {
    if (!edit.allocate(arena, plan)) return SINEW_ERROR_WORKSPACE;
    status = edit_rows(plan, p, logits, joints, weights, arena, &edit);
    if (status != SINEW_OK) return status;
  }
  if (!plan.progress.report(1000)) return SINEW_ERROR_CANCELLED;
  plan.counts.threads.ranges(p.mesh.vertex_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    write_rows(plan, p, logits, edit, begin, end, joints, weights);
  });
  count_symmetric(plan, p, edit);
  if (used_bytes != nullptr) *used_bytes = arena.high_water();
  return SINEW_OK;
}

}  // namespace sinew
