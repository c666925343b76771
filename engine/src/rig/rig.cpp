// SPDX-License-Identifier: MIT
// Mesh to mirror frame to points to votes to joints to the caller's units.
#include "rig/rig.hpp"

#include <string.h>

#include "core/build.hpp"
#include "core/read_skeleton.hpp"
#include "core/struct_size.hpp"
#include "grid/caller_units.hpp"
#include "kernels/select.hpp"
#include "model/task.hpp"
#include "rig/folded_tree.hpp"
#include "rig/rig_joint.hpp"
#include "rig/tree.hpp"
#include "sinew/published.h"
#include "votes/read_votes.hpp"
#include "votes/rig_task.hpp"

namespace sinew::rigging {
namespace {

// Ends of the stages, permille.
constexpr uint32_t kMeshEnds = 150, kPointsEnd = 400, kVotesEnd = 800;

static_assert(kMaxRigJoints == SINEW_MAX_RIG_JOINTS && kMaxJointName == SINEW_JOINT_NAME_BYTES,
              "the limits of the header and of the source are equal");

// A point of the mirror frame in the caller's units. What mirrors there mirrors here, because both sides are the middle and
// the same length away from it; the middle is 0 where it is that within a step of the grid.
struct Placer {
  const Units& units;
  const MirrorFrame& frame;
  uint32_t up_axis;
  double plane;  // across x, or z if the frame is rotated

  Placer(const Units& u, const MirrorFrame& f, uint32_t up) : units(u), frame(f), up_axis(up) {
    plane = units.zero(frame.turned() ? 2 : 0) + units.length(frame.plane);
    const double step = units.length(1);
    if (plane <= step && plane >= -step) plane = 0;
  }
  void place(Vec3i p, float* out) const {
    const double y = units.zero(1) + units.length(p.y);
    const Vec3i q = MirrorFrame::turn(p, 4 - frame.quarters);
    const double x = (frame.turned() ? units.zero(0) : plane) + units.length(q.x);
    const double z = (frame.turned() ? plane : units.zero(2)) + units.length(q.z);
    out[0] = to_float(x);
    out[1] = to_float(up_axis == 0 ? y : -z);
    out[2] = to_float(up_axis == 0 ? z : y);
  }
};

// How far off the votes of a set think they are: mean of log2, Q10. Small is good.
int64_t doubt_of(const int16_t* outputs) {
  int64_t sum = 0;
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const int16_t* const row = outputs + size_t{i} * kRigOutputs;
    sum += int64_t{row[kRigStartSpread]} + row[kRigEndSpread];
  }
  return sum / (2 * kSetPoints);
}

// Rotates the mesh to the front with the surest votes: front and back of a mirrored mesh, all four sides of another.
// Rotations other than none must be better by kRotationGain. The voter keeps the interior of the chosen rotation and,
// without rotation, the votes of set 0.
constexpr int64_t kRotationGain = 60;  // Q10 of log2

sinew_status choose_facing(const RigPlan& plan, const Kernels& kernels, Arena& arena, PointVoter* voter,
                           MirrorFrame* frame, Mesh* mesh, bool* turned) {
  const uint32_t step = frame->folded ? 2 : 1;
  int64_t least = INT64_MAX;
  uint32_t best = 0, at = 0;
  for (uint32_t tried = step; tried <= 4; tried += step) {  // no rotation comes last: mostly it stays so
    const uint32_t quarters = tried % 4;
    if (!arena.measuring()) turn_frame(quarters + 4 - at, frame, mesh);
    at = quarters;
    if (!build_interior(*mesh, arena, &voter->interior)) return SINEW_ERROR_WORKSPACE;
    const sinew_status status = voter->run(plan.model, plan.network, kernels, *mesh, 0, {}, arena);
    if (status != SINEW_OK) return status;
    if (arena.measuring()) return SINEW_OK;
    const int64_t doubt = doubt_of(voter->outputs) + (quarters == 0 ? 0 : kRotationGain);
    if (doubt < least || (quarters == 0 && doubt == least)) {
      least = doubt;
      best = quarters;
    }
  }
  *turned = best != at;
  if (!*turned) return SINEW_OK;
  turn_frame(best + 4 - at, frame, mesh);
  return build_interior(*mesh, arena, &voter->interior) ? SINEW_OK : SINEW_ERROR_WORKSPACE;
}

sinew_status vote(const RigPlan& plan, const Kernels& kernels, Arena& arena, bool front_known, MirrorFrame* frame,
                  Mesh* mesh, Rig* rig) {
  const ArenaScope scope(arena);
  VoteStore store;
  (void)store.allocate(arena, kRigSets);
  PointVoter voter;
  voter.other = plan.other;
  if (!voter.allocate(arena)) return SINEW_ERROR_WORKSPACE;
  const Progress progress = arena.measuring() ? Progress() : plan.progress;  // the size query is silent
  bool turned = front_known, sheet = false;
  sinew_status status = front_known && !arena.measuring()
                            ? (build_interior(*mesh, arena, &voter.interior) ? SINEW_OK : SINEW_ERROR_WORKSPACE)
                            : choose_facing(plan, kernels, arena, &voter, frame, mesh, &turned);
  if (status != SINEW_OK) return status;
  if (!progress.report(kPointsEnd)) return SINEW_ERROR_CANCELLED;
  for (uint32_t i = 0; i < kRigSets; ++i) {
    const Progress part = progress.part(kPointsEnd + i * (kVotesEnd - kPointsEnd) / kRigSets,
                                        kPointsEnd + (i + 1) * (kVotesEnd - kPointsEnd) / kRigSets);
    if (i > 0 || turned) status = voter.run(plan.model, plan.network, kernels, *mesh, i, part, arena);
    if (status != SINEW_OK) return status;
    if (arena.measuring()) continue;
    if (i == 0) sheet = is_sheet(voter.set.points, kSetPoints);
    store.add(voter.set, voter.outputs, frame->folded, plan.tree.kind);
  }
  if (!progress.report(kVotesEnd)) return SINEW_ERROR_CANCELLED;
  Votes votes;
  votes.points = kRigSets * kSetPoints;
  if (!arena.measuring()) votes = store.votes(frame->folded);
  status = find_rig(votes, plan.tree, &voter.interior, arena, rig);
  if (sheet && rig->spread < kSheetSpread) rig->spread = kSheetSpread;
  return status;
}

// By other means than votes: both networks of slots; without a network the mesh's own middle line, or the regions
// that its surface falls into.
sinew_status follow_shape(const RigPlan& plan, const Kernels& kernels, const MirrorFrame& frame, const Mesh& mesh,
                          Arena& arena, Rig* rig) {
  if (plan.method == SINEW_RIG_SLOTS) {
    const Progress progress = arena.measuring() ? Progress() : plan.progress.part(kMeshEnds, 1000);
    return find_slots(plan.slots, plan.tree, mesh, kernels, progress, arena, rig);
  }
  const ArenaScope scope(arena);
  Interior interior;
  FoldedTree* const tree = arena.alloc<FoldedTree>(1);
  if (plan.method == SINEW_RIG_REGIONS) {
    if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring() && !plan.progress.report(kVotesEnd)) return SINEW_ERROR_CANCELLED;
    const sinew_status status = grow_regions(mesh, plan.counts, arena, tree);
    if (status == SINEW_OK && !arena.measuring()) unfold_tree(plan.tree, tree, rig);
    return status;
  }
  if (!interior.allocate(arena) || !build_interior(mesh, arena, &interior)) return SINEW_ERROR_WORKSPACE;
  if (!arena.measuring() && !plan.progress.report(kVotesEnd)) return SINEW_ERROR_CANCELLED;
  const sinew_status status = grow_curve(interior, frame.folded && plan.tree.fold, arena, tree);
  if (status == SINEW_OK && !arena.measuring()) unfold_tree(plan.tree, tree, rig);
  return status;
}

void write_outputs(const UprightMesh& upright, const MirrorFrame& frame, const Rig& rig, sinew_rig_outputs* out) {
  const Units units(upright.mesh, upright.up_axis);
  const Placer placer(units, frame, upright.up_axis);
  const Turn& turn = upright.front.turn;
  out->joint_count = rig.count;
  for (uint32_t j = 0; j < rig.count; ++j) {
    const RigJoint& joint = rig.joints[j];
    float* const position = out->positions + size_t{3} * j;
    placer.place(joint.position, position);
    if (!turn.nothing()) {
      const double at[3] = {static_cast<double>(position[0]), static_cast<double>(position[1]),
                            static_cast<double>(position[2])};
      turn.from(at, position);
    }
    out->parents[j] = joint.parent;
    if (out->flags != nullptr) out->flags[j] = joint.tip != 0 ? SINEW_JOINT_NEVER : 0;
    if (out->joint_classes != nullptr) out->joint_classes[j] = joint.joint_class;
    if (out->partners != nullptr) out->partners[j] = joint.partner;
    if (out->confidence != nullptr) out->confidence[j] = joint.confidence;
    if (out->parent_confidence != nullptr) out->parent_confidence[j] = joint.parent_confidence;
  }
  if (out->names != nullptr) name_joints(rig.joints, rig.count, out->names);
  out->mirrored = frame.folded ? 1 : 0;
  write_front(upright, frame.quarters, placer.plane, out);
  out->spread = static_cast<float>(rig.spread) / 65536.0f;
}

}  // namespace

sinew_status plan_rig(const sinew_model* model, uint32_t vertices, uint32_t faces, uint32_t corners,
                      const sinew_rig_options* options, RigPlan* plan, uint32_t feature_set) {
  sinew_rig_options o = SINEW_INIT(sinew_rig_options);
  const sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstRigOptionsSize, sizeof o, &o);
  if (status != SINEW_OK) return status;
  const sinew_status front = plan_front(o, &plan->front);
  if (front != SINEW_OK) return front;
  if (o.mirror > SINEW_MIRROR_NEVER || o.spine_count > kMaxSpine ||
      (o.without & ~uint32_t{SINEW_WITHOUT_TOES | SINEW_WITHOUT_ENDS}) != 0 || o.weights_in_place > 1 ||
      kernel_name(o.kernel) == nullptr || o.method > SINEW_RIG_SLOTS || o.category >= kBodyKinds ||
      (o.category != 0 && o.method != SINEW_RIG_VOTES && o.method != SINEW_RIG_SLOTS)) {
    return SINEW_ERROR_ARGUMENT;
  }
  const bool published = o.method == SINEW_RIG_REGIONS || o.method == SINEW_RIG_SLOTS;
  if (published && !has_published_methods()) return SINEW_ERROR_NOT_BUILT;
  if (o.method == SINEW_RIG_VOTES) {
    if (model == nullptr || model->bytes == nullptr) return SINEW_ERROR_ARGUMENT;
    if (model->task != kTaskRig || model->feature_set != feature_set) return SINEW_ERROR_MODEL_TASK;
    plan->model = *model;
  }
  if (o.method == SINEW_RIG_SLOTS) {
    const sinew_status opened = plan_slots(model, &plan->slots);
    if (opened != SINEW_OK) return opened;
    plan->slots.category = static_cast<BodyKind>(o.category);
  }
  if (vertices == 0 || vertices > SINEW_MAX_VERTICES || corners > 24u * SINEW_MAX_VERTICES || faces > corners / 2)
    return SINEW_ERROR_COUNT;
  plan->counts = Counts();
  plan->counts.vertices = vertices;
  plan->counts.faces = faces;
  plan->counts.corners = corners;
  plan->network = NetworkOptions();
  plan->network.weights_in_place = o.weights_in_place != 0 || o.kernel == SINEW_KERNEL_REF;
  plan->slots.network = plan->front.network = plan->network;
  plan->tree = RigOptions();
  plan->tree.spine = o.spine_count == 0 ? -1 : static_cast<int32_t>(o.spine_count);
  plan->tree.toes = (o.without & SINEW_WITHOUT_TOES) == 0;
  plan->tree.ends = (o.without & SINEW_WITHOUT_ENDS) == 0;
  plan->tree.kind = static_cast<BodyKind>(o.category);
  plan->mirroring = published ? Mirroring::kNever : static_cast<Mirroring>(o.mirror);
  plan->method = o.method;
  plan->up_axis = plan->front.up_axis;
  plan->kernel = o.kernel;
  plan->progress = Progress{o.progress, o.progress_user};
  plan->other = OtherNetwork();
  return SINEW_OK;
}

sinew_status run_rig(const RigPlan& plan, const sinew_mesh& mesh_input, const Kernels& kernels, Arena& arena,
                     sinew_rig_outputs* outputs) {
  Mesh mesh;
  Rig rig;
  MirrorFrame frame;
  UprightMesh upright;
  const bool votes_wanted = plan.method == SINEW_RIG_VOTES;
  (void)mesh.allocate(arena, plan.counts);
  if (!rig.allocate(arena)) return SINEW_ERROR_WORKSPACE;
  sinew_status status = stand_upright(plan.front, mesh_input, plan.counts, kernels, arena, &mesh, &upright);
  if (status != SINEW_OK) return status;
  int32_t middles[2] = {0, 0};
  if (!arena.measuring()) {
    const float zero[3] = {0, 0, 0};
    const Vec3i middle = quantize_point(upright.quantizer, zero);
    middles[0] = middle.x;
    middles[1] = middle.z;
  }
  if (!find_mirror_frame(mesh, plan.mirroring, middles, plan.front.may_turn(), arena, &frame))
    return SINEW_ERROR_WORKSPACE;
  if (!arena.measuring()) {
    apply_mirror_frame(frame, &mesh);
    if (!plan.progress.report(kMeshEnds)) return SINEW_ERROR_CANCELLED;
  }
  if (votes_wanted) {
    status = vote(plan, kernels, arena, upright.known, &frame, &mesh, &rig);
  } else {
    status = follow_shape(plan, kernels, frame, mesh, arena, &rig);
  }
  if (status != SINEW_OK || arena.measuring()) return status;
  write_outputs(upright, frame, rig, outputs);
  outputs->used_bytes = arena.high_water();
  return SINEW_OK;
}

}  // namespace sinew::rigging
