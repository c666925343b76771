// SPDX-License-Identifier: MIT
// Makes a plan: worlds, limbs, rest poses, lengths, floor.
#include "motion/retarget_plan.hpp"

#include <stddef.h>

#include "core/struct_size.hpp"
#include "sinew/rig.h"

namespace sinew::motion {
namespace {

// The struct of the first release.
constexpr uint32_t kFirstOptionsSize = offsetof(sinew_retarget_options, translations);

bool is_arm_class(uint32_t c) { return c == SINEW_CLASS_UPPER_ARM || c == SINEW_CLASS_FOREARM; }
bool is_leg_class(uint32_t c) { return c == SINEW_CLASS_THIGH || c == SINEW_CLASS_CALF; }

class Planner {
 public:
  Planner(const RetargetOptions& options, sinew_retarget* plan)
      : options_(options), plan_(*plan), source_(plan->source), target_(plan->target) {}

  void run(uint32_t* scratch) {
    hang_roots(&plan_, scratch);
    uint8_t* const has_mapped = reinterpret_cast<uint8_t*>(scratch);
    for (uint32_t t = 0; t < target_.count; ++t) plan_.carriers[t] = carrier_of(t);
    find_long_bones();
    find_anchors_and_floor();
    find_worlds(options_, &plan_);
    find_mover(has_mapped);
    measure();
    align_rest_poses();
  }

 private:
  uint32_t class_of(uint32_t t) const { return plan_.classes[t]; }
  bool is_mapped(uint32_t t) const { return plan_.map[t] >= 0; }
  uint32_t source_of(uint32_t t) const { return static_cast<uint32_t>(plan_.map[t]); }
  Vec3d source_position(uint32_t t) const { return source_.positions[source_of(t)]; }

  // The nearest mapped joint above that is of this class, or -1.
  int32_t mapped_above(uint32_t t, uint32_t wanted) const {
    for (int32_t at = target_.parents[t]; at >= 0; at = target_.parents[at]) {
      if (is_mapped(static_cast<uint32_t>(at)) && class_of(static_cast<uint32_t>(at)) == wanted) return at;
    }
    return -1;
  }

  // Feet and hands for inverse kinematics are below the root. If the source's are children of their limbs they follow
  // the calf or forearm; -1 if they are its children, or the source's are not.
  int32_t carrier_of(uint32_t t) const {
    const uint32_t own = class_of(t), before = class_before(own);
    if (!is_mapped(t) || (own != SINEW_CLASS_FOOT && own != SINEW_CLASS_HAND)) return -1;
    for (int32_t at = target_.parents[t]; at >= 0; at = target_.parents[at]) {
      if (class_of(static_cast<uint32_t>(at)) == before || class_of(static_cast<uint32_t>(at)) == own) return -1;
    }
    for (int32_t s = source_.parents[source_of(t)]; s >= 0; s = source_.parents[s]) {
      for (uint32_t c = 0; c < target_.count; ++c) {
        if (plan_.map[c] == s && class_of(c) == before) return static_cast<int32_t>(c);
      }
    }
    return -1;
  }

  // A limb's long bone goes from the first mapped joint of its class (twist joints follow) to the first mapped one of the
  // next class.
  void find_long_bones() {
    for (uint32_t t = 0; t < target_.count; ++t) plan_.long_ends[t] = -1;
    for (uint32_t i = 0; i < target_.count; ++i) {
      const uint32_t t = target_.order[i];
      if (!is_mapped(t)) continue;
      const uint32_t own = class_of(t), before = class_before(own);
      if (before == SINEW_CLASS_OTHER || mapped_above(t, own) >= 0) continue;
      int32_t begin = plan_.carriers[t] >= 0 ? plan_.carriers[t] : mapped_above(t, before);
      for (int32_t up = begin; up >= 0; up = mapped_above(static_cast<uint32_t>(up), before)) begin = up;
      if (begin < 0 || plan_.map[begin] == plan_.map[t] || plan_.long_ends[begin] >= 0) continue;
      plan_.long_ends[begin] = static_cast<int32_t>(t);
    }
  }

  // Legs: where they begin is held, where they end stands. Without legs: the topmost mapped joints, and all.
  void find_anchors_and_floor() {
    plan_.anchor_count = plan_.floor_count = 0;
    for (uint32_t t = 0; t < target_.count; ++t) {
      if (plan_.long_ends[t] < 0 || class_of(t) != SINEW_CLASS_THIGH) continue;
      plan_.anchors[plan_.anchor_count++] = t;
      uint32_t end = static_cast<uint32_t>(plan_.long_ends[t]);
      if (plan_.long_ends[end] >= 0) end = static_cast<uint32_t>(plan_.long_ends[end]);
      plan_.floor_joints[plan_.floor_count++] = end;
    }
    plan_.has_legs = plan_.anchor_count > 0;
    if (plan_.has_legs) return;
    const uint32_t root = busiest_root(plan_, plan_.anchors);
    for (uint32_t t = 0; t < target_.count; ++t) {
      if (!is_mapped(t) || target_.root_of(t) != root) continue;
      plan_.floor_joints[plan_.floor_count++] = t;
      int32_t above = target_.parents[t];
      while (above >= 0 && !is_mapped(static_cast<uint32_t>(above))) above = target_.parents[above];
      if (above < 0) plan_.anchors[plan_.anchor_count++] = t;
    }
  }

  // A mapped joint just above the one that carries the legs: it has skin of its own and goes where they go. Farther
  // above if it has other children, such as a tail without a source.
  bool is_pelvis_of(int32_t above, int32_t joint) const {
    if (!plan_.has_legs || above < 0 || !is_mapped(static_cast<uint32_t>(above))) return false;
    constexpr double kNear = 0.2, kNearWithOthers = 0.6;  // of a leg
    bool others = false;
    for (uint32_t t = 0; t < target_.count; ++t)
      others = others || (target_.parents[t] == above && static_cast<int32_t>(t) != joint);
    return length(target_.positions[above] - target_.positions[joint]) <
           (others ? kNearWithOthers : kNear) *
               length(target_.positions[plan_.anchors[0]] - target_.positions[plan_.floor_joints[0]]);
  }

  // The first joint from the root at which mapped joints branch, or the pelvis just above; without branches the topmost mapped
  // one.
  void find_mover(uint8_t* has_mapped) {
    for (uint32_t t = 0; t < target_.count; ++t) has_mapped[t] = is_mapped(t) ? 1 : 0;
    for (uint32_t i = target_.count; i-- > 0;) {
      const uint32_t t = target_.order[i];
      if (has_mapped[t] != 0 && target_.parents[t] >= 0) has_mapped[target_.parents[t]] = 1;
    }
    // Above the first anchor: a prop that is a root of its own is not what walks.
    int32_t top = static_cast<int32_t>(plan_.anchors[0]);
    while (target_.parents[top] >= 0) top = target_.parents[top];
    const int32_t root = top;
    for (;;) {
      int32_t only = -1;
      uint32_t branches = 0;
      for (uint32_t t = 0; t < target_.count; ++t) {
        if (target_.parents[t] != top || has_mapped[t] == 0) continue;
        only = static_cast<int32_t>(t);
        ++branches;
      }
      if (branches > 1) break;
      if (branches == 0) {  // a chain: from its top
        for (; top != root; top = target_.parents[top]) {
          bool mapped_above = false;
          for (int32_t up = target_.parents[top]; up >= 0; up = target_.parents[up])
            mapped_above = mapped_above || is_mapped(static_cast<uint32_t>(up));
          if (!mapped_above) break;
        }
        break;
      }
      top = only;
    }
    while (is_pelvis_of(target_.parents[top], top)) top = target_.parents[top];
    plan_.mover = top;
    for (uint32_t i = 0; i < target_.count; ++i) {
      const uint32_t t = target_.order[i];
      const int32_t parent = target_.parents[t];
      plan_.moved[t] = static_cast<int32_t>(t) == top || (parent >= 0 && plan_.moved[parent] != 0) ? 1 : 0;
    }
  }

  // Hands, and all below an arm, keep the forearm's: a hand that was in line with it stays so. Feet, and hands that stand on
  // the floor, keep their own rest pose, in which they are flat.
  void align_rest_poses() {
    for (uint32_t i = 0; i < target_.count; ++i) {
      const uint32_t t = target_.order[i];
      const int32_t end = plan_.long_ends[t], parent = target_.parents[t];
      plan_.align[t] = kNoRotation;
      if (end >= 0) {
        const uint32_t e = static_cast<uint32_t>(end);
        plan_.align[t] = shortest_arc(target_.positions[e] - target_.positions[t],
                                      rotate(plan_.rotation, source_position(e) - source_position(t)));
      } else if (parent >= 0 && inherits(t)) {
        plan_.align[t] = plan_.align[parent];
      }
    }
  }
  bool stands(uint32_t t) const {
    const uint32_t own = class_of(t);
    if (own != SINEW_CLASS_HAND || !plan_.has_legs) return own == SINEW_CLASS_FOOT;
    return dot(plan_.up, target_.positions[t]) < plan_.target_floor + 0.15 * plan_.scale * plan_.leg_length;
  }
  // Below an arm's long bone, or below a leg's without a source of its own.
  bool inherits(uint32_t t) const {
    for (int32_t at = target_.parents[t]; at >= 0; at = target_.parents[at]) {
      const uint32_t own = class_of(static_cast<uint32_t>(at));
      if (stands(t) || stands(static_cast<uint32_t>(at))) return false;
      if (plan_.long_ends[at] >= 0) return is_arm_class(own) || is_leg_class(class_of(t)) || !is_mapped(t);
    }
    return false;
  }

  void measure() {
    double lengths_s = 0, lengths_t = 0, all_s = 0, all_t = 0;
    for (uint32_t t = 0; t < target_.count; ++t) {
      if (!is_mapped(t)) continue;
      if (plan_.long_ends[t] >= 0 && is_leg_class(class_of(t))) {
        const uint32_t e = static_cast<uint32_t>(plan_.long_ends[t]);
        lengths_s += length(source_position(e) - source_position(t));
        lengths_t += length(target_.positions[e] - target_.positions[t]);
      }
      int32_t above = target_.parents[t];
      while (above >= 0 && !is_mapped(static_cast<uint32_t>(above))) above = target_.parents[above];
      if (above < 0) continue;
      const uint32_t a = static_cast<uint32_t>(above);
      all_s += length(source_position(t) - source_position(a));
      all_t += length(target_.positions[t] - target_.positions[a]);
    }
    const bool by_legs = lengths_s > 0 && lengths_t > 0;
    const double s = by_legs ? lengths_s : all_s, t = by_legs ? lengths_t : all_t;
    plan_.scale = options_.scale > 0 ? options_.scale : s > 0 && t > 0 ? t / s : 1;
    plan_.leg_length = by_legs ? s / plan_.anchor_count : s;

    find_same_rig();
    find_flight_scale();
    double source_sum = 0, target_sum = 0, source_low = 0, target_low = 0;
    for (uint32_t i = 0; i < plan_.floor_count; ++i) {
      const uint32_t joint = plan_.floor_joints[i];
      const double own = dot(plan_.up, target_.positions[joint]);
      const double from = dot(plan_.up, rotate(plan_.rotation, source_position(joint)));
      source_sum += from;
      target_sum += own;
      if (i == 0 || from < source_low) source_low = from;
      if (i == 0 || own < target_low) target_low = own;
    }
    plan_.source_floor = plan_.has_legs ? source_sum / plan_.floor_count : source_low;
    plan_.target_floor = plan_.has_legs ? target_sum / plan_.floor_count : target_low;
    for (uint32_t j = 0; j < source_.count; ++j) {
      const double height = dot(plan_.up, rotate(plan_.rotation, source_.positions[j]));
      if (j == 0 || height < plan_.source_lowest) plan_.source_lowest = height;
    }
  }

  // Short legs jump as high as the body needs to rotate in the air.
  void find_flight_scale() {
    constexpr double kMost = 2;
    plan_.flight_scale = plan_.scale;
    if (!plan_.has_legs || options_.scale > 0) return;
    double low[2] = {0, 0}, high[2] = {0, 0};
    bool any = false;
    for (uint32_t t = 0; t < target_.count; ++t) {
      if (!is_mapped(t)) continue;
      const double heights[2] = {dot(plan_.up, rotate(plan_.rotation, source_position(t))),
                                 dot(plan_.up, target_.positions[t])};
      for (int i = 0; i < 2; ++i) {
        low[i] = any ? lesser(low[i], heights[i]) : heights[i];
        high[i] = any ? greater(high[i], heights[i]) : heights[i];
      }
      any = true;
    }
    const double from = high[0] - low[0];
    const double whole = from > 0 ? (high[1] - low[1]) / from : 0;
    if (whole > plan_.scale) plan_.flight_scale = lesser(whole, kMost * plan_.scale);
  }

  // Within a hundred-thousandth of a leg, as seen from the first anchor.
  void find_same_rig() {
    const double off = plan_.scale < 1 ? 1 - plan_.scale : plan_.scale - 1;
    plan_.same_rig = off < 1e-6;
    const uint32_t a = plan_.anchors[0];
    for (uint32_t t = 0; t < target_.count; ++t) {
      if (!is_mapped(t)) continue;
      const Vec3d from = rotate(plan_.rotation, source_position(t) - source_position(a));
      if (length(target_.positions[t] - target_.positions[a] - from) > 1e-5 * plan_.leg_length) plan_.same_rig = false;
    }
  }

  const RetargetOptions& options_;
  sinew_retarget& plan_;
  const MotionRig& source_;
  const MotionRig& target_;
};

}  // namespace

uint32_t class_before(uint32_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_FOREARM:
      return SINEW_CLASS_UPPER_ARM;
    case SINEW_CLASS_HAND:
      return SINEW_CLASS_FOREARM;
    case SINEW_CLASS_CALF:
      return SINEW_CLASS_THIGH;
    case SINEW_CLASS_FOOT:
      return SINEW_CLASS_CALF;
    default:
      return SINEW_CLASS_OTHER;
  }
}

sinew_status read_retarget_options(const sinew_retarget_options* options, RetargetOptions* out) {
  sinew_retarget_options o = SINEW_INIT(sinew_retarget_options);
  const sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstOptionsSize, sizeof o, &o);
  if (status != SINEW_OK) return status;
  const double scale = static_cast<double>(o.scale), arm_spread = static_cast<double>(o.arm_spread);
  if (o.method > SINEW_RETARGET_NODE_OFFSETS || o.in_place > 1 || o.translations > 1 || !is_finite(scale) ||
      scale < 0 || !(absolute(arm_spread) <= 90)) {
    return SINEW_ERROR_ARGUMENT;
  }
  *out = RetargetOptions();
  out->node_offsets = o.method == SINEW_RETARGET_NODE_OFFSETS;
  out->in_place = o.in_place != 0;
  out->translations = o.translations != 0;
  out->scale = scale;
  out->arm_spread = arm_spread;
  return SINEW_OK;
}

namespace {

// All memory of a plan, itself included, and scratch for making it.
struct PlanMemory {
  sinew_retarget made;
  sinew_retarget* plan = nullptr;
  uint32_t* scratch = nullptr;

  bool allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints) {
    plan = arena.alloc<sinew_retarget>(1);
    (void)made.source.allocate(arena, source_joints);
    (void)made.target.allocate(arena, target_joints);
    made.map = arena.alloc<int32_t>(target_joints);
    made.classes = arena.alloc<uint8_t>(target_joints);
    made.long_ends = arena.alloc<int32_t>(target_joints);
    made.carriers = arena.alloc<int32_t>(target_joints);
    made.align = arena.alloc<Quat>(target_joints);
    made.moved = arena.alloc<uint8_t>(target_joints);
    made.anchors = arena.alloc<uint32_t>(target_joints);
    made.floor_joints = arena.alloc<uint32_t>(target_joints);
    made.source_rotations = arena.alloc<Quat>(source_joints);
    made.source_positions = arena.alloc<Vec3d>(source_joints);
    made.target_rotations = arena.alloc<Quat>(target_joints);
    made.target_positions = arena.alloc<Vec3d>(target_joints);
    const uint32_t larger = source_joints > target_joints ? source_joints : target_joints;
    scratch = arena.alloc<uint32_t>(size_t{2} * larger + 1);
    return arena.ok();
  }
};

}  // namespace

size_t measure_plan(uint32_t source_joints, uint32_t target_joints) {
  Arena arena;
  PlanMemory memory;
  (void)memory.allocate(arena, source_joints, target_joints);
  return arena.high_water();
}

sinew_status create_plan(const sinew_skeleton& source, const sinew_skeleton& target, const int32_t* map,
                         const uint8_t* classes, const RetargetOptions& options, void* memory, size_t memory_bytes,
                         sinew_retarget** plan) {
  Arena arena(memory, memory_bytes);
  PlanMemory room;
  if (!room.allocate(arena, source.joint_count, target.joint_count)) return SINEW_ERROR_WORKSPACE;
  sinew_retarget& made = room.made;
  sinew_status status = made.source.fill(source, room.scratch);
  if (status == SINEW_OK) status = made.target.fill(target, room.scratch);
  if (status != SINEW_OK) return status;
  bool any = false;
  for (uint32_t t = 0; t < target.joint_count; ++t) {
    if (map[t] < -1 || map[t] >= static_cast<int32_t>(source.joint_count)) return SINEW_ERROR_INDEX;
    made.map[t] = map[t];
    made.classes[t] = classes == nullptr ? uint8_t{SINEW_CLASS_OTHER} : classes[t];
    any = any || map[t] >= 0;
  }
  if (!any) return SINEW_ERROR_NO_JOINT;
  made.node_offsets = options.node_offsets;
  made.in_place = options.in_place;
  made.translations = options.translations;
  made.arm_spread = options.arm_spread;
  RetargetOptions with_up = options;
  with_up.source_up = source.up;
  with_up.target_up = target.up;
  Planner(with_up, &made).run(room.scratch);
  *room.plan = made;
  *plan = room.plan;
  return SINEW_OK;
}

}  // namespace sinew::motion
