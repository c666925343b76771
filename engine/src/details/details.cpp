// SPDX-License-Identifier: MIT
// Hands, faces and props in this order, and the caller's skeleton back if one of them fails.
#include "details/details.hpp"

#include <string.h>

#include "core/struct_size.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kAllDetails = SINEW_DETAIL_HANDS | SINEW_DETAIL_FACE | SINEW_DETAIL_PROPS;

// The caller's arrays as they came, with their room for more joints.
class KeptSkeleton {
 public:
  bool allocate(Arena& arena) {
    for (int i = 0; i < kArrays; ++i) kept_[i] = arena.alloc<uint8_t>(size_t{SINEW_MAX_RIG_JOINTS} * kBytes[i]);
    return arena.ok();
  }
  void keep(const sinew_rig_outputs& outputs) { copy(outputs, true); }
  void restore(const sinew_rig_outputs& outputs) { copy(outputs, false); }
  const float* position(uint32_t joint) const { return reinterpret_cast<const float*>(kept_[0]) + size_t{3} * joint; }

 private:
  static constexpr int kArrays = 8;
  static constexpr size_t kBytes[kArrays] = {
      3 * sizeof(float), sizeof(int32_t),       1, 1, sizeof(int32_t), sizeof(uint16_t),
      sizeof(uint16_t),  SINEW_JOINT_NAME_BYTES};

  void copy(const sinew_rig_outputs& o, bool keep) {
    void* const theirs[kArrays] = {o.positions,  o.parents,           o.flags, o.joint_classes, o.partners,
                                   o.confidence, o.parent_confidence, o.names};
    for (int i = 0; i < kArrays; ++i) {
      if (theirs[i] == nullptr) continue;
      if (keep) memcpy(kept_[i], theirs[i], SINEW_MAX_RIG_JOINTS * kBytes[i]);
      if (!keep) memcpy(theirs[i], kept_[i], SINEW_MAX_RIG_JOINTS * kBytes[i]);
    }
  }

  uint8_t* kept_[kArrays] = {};
};

// A skeleton that faces between the axes is processed with its mesh rotated to y up and front +z.
class TurnedSkeleton {
 public:
  // Returns whether it has to be rotated.
  bool read(const sinew_rig_outputs& outputs) {
    turn_ = Turn::of(outputs.front, outputs.up == SINEW_UP_Z ? 1 : 0);
    return turn_.sine != 0 && turn_.cosine != 0;
  }
  const Turn& turn() const { return turn_; }
  void turn_there(sinew_rig_outputs* outputs) {
    facing_ = outputs->facing;
    plane_ = outputs->plane;
    outputs->facing = 0;
    if (turn_.cosine < 0) outputs->plane = -plane_;
    for (uint32_t j = 0; j < outputs->joint_count; ++j)
      turned(outputs->positions + size_t{3} * j, outputs->positions + size_t{3} * j);
  }
  // Joints that are where they were get the bits that they had.
  void turn_back(const KeptSkeleton& kept, uint32_t before, sinew_rig_outputs* outputs) const {
    outputs->facing = facing_;
    outputs->plane = plane_;
    for (uint32_t j = 0; j < outputs->joint_count; ++j) {
      float* const p = outputs->positions + size_t{3} * j;
      if (j < before) {
        float was[3];
        turned(kept.position(j), was);
        if (memcmp(was, p, sizeof was) == 0) {
          memcpy(p, kept.position(j), sizeof was);
          continue;
        }
      }
      const double at[3] = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
      turn_.from(at, p);
    }
  }

 private:
  void turned(const float* from, float* to) const {
    double at[3];
    turn_.to(from, at);
    for (int axis = 0; axis < 3; ++axis) to[axis] = to_float(at[axis]);
  }

  Turn turn_;
  uint32_t facing_ = 0;
  float plane_ = 0;
};

}  // namespace

sinew_status plan_details(const sinew_model* hands_model, uint32_t vertices, uint32_t faces, uint32_t corners,
                          uint32_t wanted, const sinew_rig_options* options, DetailsPlan* plan) {
  sinew_rig_options own = SINEW_INIT(sinew_rig_options);
  sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstRigOptionsSize, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (wanted == 0 || (wanted & ~kAllDetails) != 0) return SINEW_ERROR_ARGUMENT;
  own.struct_size = sizeof own;
  plan->wanted = wanted;
  own.method = SINEW_RIG_VOTES;
  if ((wanted & SINEW_DETAIL_HANDS) != 0)
    status = plan_rig(hands_model, vertices, faces, corners, &own, &plan->hands, kHandsFeatureSet);
  own.method = SINEW_RIG_SHAPE;
  if (status == SINEW_OK) status = plan_rig(nullptr, vertices, faces, corners, &own, &plan->shape);
  return status;
}

sinew_status run_details(const DetailsPlan& plan, const sinew_mesh& mesh_input, const Kernels& kernels, Arena& arena,
                         sinew_rig_outputs* outputs) {
  uint32_t stages = 0, done = 0;
  for (uint32_t bits = plan.wanted; bits != 0; bits &= bits - 1) ++stages;
  KeptSkeleton kept;
  TurnedSkeleton turned;
  if (!kept.allocate(arena)) return SINEW_ERROR_WORKSPACE;
  const uint32_t joint_count = arena.measuring() ? 0 : outputs->joint_count;
  bool turning = false;
  if (!arena.measuring()) {
    if (joint_count == 0 || joint_count > SINEW_MAX_RIG_JOINTS) return SINEW_ERROR_COUNT;
    kept.keep(*outputs);
    turning = turned.read(*outputs);
  }
  float* const positions = arena.alloc<float>(size_t{3} * plan.shape.counts.vertices);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  sinew_mesh mesh = mesh_input;
  if (turning) {
    mesh = turn_mesh(mesh_input, turned.turn(), positions);
    turned.turn_there(outputs);
  }
  const bool told = !arena.measuring() && outputs->up != 0;
  const uint32_t up_axis = turning ? 0 : told ? (outputs->up == SINEW_UP_Z ? 1u : 0u) : plan.shape.up_axis;
  // A stage's plan, with its share of the progress.
  const auto next = [&](const RigPlan& from) {
    RigPlan stage = from;
    stage.up_axis = up_axis;
    stage.progress = from.progress.part(done * Progress::kWhole / stages, (done + 1) * Progress::kWhole / stages);
    ++done;
    return stage;
  };
  sinew_status status = SINEW_OK;
  if ((plan.wanted & SINEW_DETAIL_HANDS) != 0) {
    const ArenaScope scope(arena);
    status = run_hands(next(plan.hands), mesh, kernels, arena, outputs);
  }
  if (status == SINEW_OK && (plan.wanted & SINEW_DETAIL_FACE) != 0) {
    const ArenaScope scope(arena);
    status = run_face(next(plan.shape), mesh, arena, outputs);
  }
  if (status == SINEW_OK && (plan.wanted & SINEW_DETAIL_PROPS) != 0) {
    const ArenaScope scope(arena);
    status = run_props(next(plan.shape), mesh, arena, outputs);
  }
  if (arena.measuring()) return status;
  if (turning) turned.turn_back(kept, joint_count, outputs);
  if (status == SINEW_OK) return status;
  outputs->joint_count = joint_count;
  kept.restore(*outputs);
  return status;
}

}  // namespace sinew::rigging
