// SPDX-License-Identifier: MIT
// Capsules along mapped bones, ring by ring.
#include "published/capsule_body.hpp"

#include "core/counts.hpp"
#include "motion/posed_body.hpp"
#include "sinew/rig.h"

namespace sinew::motion {
namespace {

// Thickness by limb proportions, the same for every skeleton: radius over the bone's length, or over the torso's (hips to neck) where a
// skeleton may cut its bones as it likes. Read off grown people.
struct Proportion {
  double of_bone, of_trunk;
};
Proportion proportion(uint32_t joint_class) {
  switch (joint_class) {  // of the joint that the bone begins at
    case SINEW_CLASS_PELVIS:
    case SINEW_CLASS_SPINE:
      return {0, 0.24};
    case SINEW_CLASS_NECK:
      return {0, 0.11};
    case SINEW_CLASS_HEAD:
      return {0, 0.19};
    case SINEW_CLASS_CLAVICLE:
    case SINEW_CLASS_HIP:
      return {0, 0.12};
    case SINEW_CLASS_UPPER_ARM:
      return {0.15, 0};
    case SINEW_CLASS_FOREARM:
      return {0.14, 0};
    case SINEW_CLASS_THIGH:
      return {0.19, 0};
    case SINEW_CLASS_CALF:
      return {0.13, 0};
    default:
      return {0.2, 0};
  }
}
// Length beyond a leaf, as a share of the bone before it; heads by the torso.
constexpr double kBeyondHead = 0.35, kBeyondLeaf = 0.6;

bool is_body(uint32_t c) { return c <= SINEW_CLASS_FOOT || c == SINEW_CLASS_TAIL || c == SINEW_CLASS_WING; }

// Hips to neck, or to the head; legs where there is none.
double trunk_of(const sinew_retarget& plan, const MotionRig& rig, bool of_source) {
  uint32_t low = kNoIndex, high = kNoIndex;
  for (uint32_t i = 0; i < plan.target.count; ++i) {
    const uint32_t t = plan.target.order[i];
    if (plan.map[t] < 0) continue;
    const uint32_t own = of_source ? static_cast<uint32_t>(plan.map[t]) : t;
    const uint32_t c = plan.classes[t];
    if (low == kNoIndex && (c == SINEW_CLASS_PELVIS || c == SINEW_CLASS_SPINE)) low = own;
    if (high == kNoIndex && (c == SINEW_CLASS_NECK || c == SINEW_CLASS_HEAD)) high = own;
  }
  const double trunk = low != kNoIndex && high != kNoIndex ? length(rig.positions[high] - rig.positions[low]) : 0;
  return trunk > 0 ? trunk : plan.leg_length * (of_source ? 0.6 : 0.6 * plan.scale);
}

void set(float* positions, Vec3d p) {
  positions[0] = static_cast<float>(p.x);
  positions[1] = static_cast<float>(p.y);
  positions[2] = static_cast<float>(p.z);
}

}  // namespace

bool CapsuleBodies::allocate(Arena& arena, uint32_t target_joints) {
  const size_t vertices = size_t{capacity(target_joints)} * kVertices;
  source_bones_ = arena.alloc<Bone>(capacity(target_joints));
  target_bones_ = arena.alloc<Bone>(capacity(target_joints));
  sums_ = arena.alloc<double>(capacity(target_joints));
  counts_ = arena.alloc<uint32_t>(capacity(target_joints));
  source_positions_ = arena.alloc<float>(3 * vertices);
  target_positions_ = arena.alloc<float>(3 * vertices);
  source_joints_ = arena.alloc<uint16_t>(vertices);
  target_joints_ = arena.alloc<uint16_t>(vertices);
  weights_ = arena.alloc<uint16_t>(vertices);
  triangles_ = arena.alloc<uint32_t>(size_t{3} * capacity(target_joints) * kTriangles);
  return arena.ok();
}

sinew_motion_body CapsuleBodies::view(const float* positions, const uint16_t* joints) const {
  return {positions, triangles_, {joints, weights_, 1, SINEW_WEIGHT_UNORM16}, count_ * kVertices, count_ * kTriangles};
}

void CapsuleBodies::build(const sinew_retarget& plan, const sinew_motion_body& mesh) {
  find_bones(plan);
  measure_target(mesh);
  count_ = 0;
  for (uint32_t b = 0; b < bone_count_; ++b) add(source_bones_[b], target_bones_[b], plan.rotation);
}

// The mean distance of the vertices that are moved most by the bone's joint and lie beside it, nearest of its bones; by proportions
// where there are few.
void CapsuleBodies::measure_target(const sinew_motion_body& mesh) {
  constexpr uint32_t kFewest = 12;
  constexpr double kThinnest = 0.5, kThickest = 2.5;  // of what proportions say
  for (uint32_t b = 0; b < bone_count_; ++b) sums_[b] = counts_[b] = 0;
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const uint32_t joint = heaviest_joint(mesh, v);
    const float* const p = mesh.positions + size_t{3} * v;
    const Vec3d position = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    uint32_t best = kNoIndex;
    double least = 0;
    for (uint32_t b = 0; b < bone_count_; ++b) {
      const Bone& bone = target_bones_[b];
      if (bone.joint != joint) continue;
      const Vec3d whole = bone.to - bone.from, offset = position - bone.from;
      const double at = dot(offset, whole) / dot(whole, whole);
      const double far = length(offset - (at < 0 ? 0 : at > 1 ? 1 : at) * whole);
      if (at < 0 || at > 1 || (best != kNoIndex && far >= least)) continue;
      best = b;
      least = far;
    }
    if (best == kNoIndex) continue;
    sums_[best] += least;
    ++counts_[best];
  }
  for (uint32_t b = 0; b < bone_count_; ++b) {
    if (counts_[b] < kFewest) continue;
    double& radius = target_bones_[b].radius;
    radius = clamped(sums_[b] / counts_[b], kThinnest * radius, kThickest * radius);
  }
}

void CapsuleBodies::find_bones(const sinew_retarget& plan) {
  const MotionRig &from = plan.source, &to = plan.target;
  const double source_trunk = trunk_of(plan, from, true), target_trunk = trunk_of(plan, to, false);
  bone_count_ = 0;
  const auto is_node = [&](uint32_t t) { return plan.map[t] >= 0 && is_body(plan.classes[t]); };
  for (uint32_t i = 0; i < to.count; ++i) {
    const uint32_t t = to.order[i];
    if (!is_node(t)) continue;
    int32_t above = to.parents[t];
    while (above >= 0 && !is_node(static_cast<uint32_t>(above))) above = to.parents[above];
    if (above < 0 || plan.map[above] == plan.map[t]) continue;
    const uint32_t up = static_cast<uint32_t>(above), s = static_cast<uint32_t>(plan.map[t]),
                   source_up = static_cast<uint32_t>(plan.map[up]);
    const auto add_bone = [&](uint32_t joint, uint32_t source_joint, Vec3d a, Vec3d b, Vec3d source_a, Vec3d source_b) {
      const Proportion own = proportion(plan.classes[joint]);
      const double bone = length(b - a), source_bone = length(source_b - source_a);
      if (!(bone > 0) || !(source_bone > 0)) return;
      target_bones_[bone_count_] = {a, b, own.of_bone * bone + own.of_trunk * target_trunk,
                                    static_cast<uint16_t>(joint)};
      source_bones_[bone_count_++] = {source_a, source_b, own.of_bone * source_bone + own.of_trunk * source_trunk,
                                      static_cast<uint16_t>(source_joint)};
    };
    const Vec3d a = to.positions[up], b = to.positions[t];
    const Vec3d source_a = from.positions[source_up], source_b = from.positions[s];
    add_bone(up, source_up, a, b, source_a, source_b);
    bool leaf = true;
    for (uint32_t k = 0; k < to.count && leaf; ++k) leaf = k == t || !is_node(k) || !to.is_below(k, t);
    const uint32_t c = plan.classes[t];
    if (!leaf || !(length(b - a) > 0) || !(length(source_b - source_a) > 0)) continue;
    const double beyond = c == SINEW_CLASS_HEAD ? kBeyondHead * target_trunk : kBeyondLeaf * length(b - a);
    const double source_beyond =
        c == SINEW_CLASS_HEAD ? kBeyondHead * source_trunk : kBeyondLeaf * length(source_b - source_a);
    add_bone(t, s, b, b + beyond * unit(b - a), source_b, source_b + source_beyond * unit(source_b - source_a));
  }
}

// Rings of one direction in the target are rotated as the bone is, and to the source's world.
void CapsuleBodies::add(const Bone& source, const Bone& target, const Quat& source_world) {
  const Quat source_from_target = shortest_arc(target.to - target.from, rotate(source_world, source.to - source.from));
  constexpr double kHalf = 0.70710678118654752440;  // cosine of 45 degrees
  constexpr double kCosines[kSides] = {1, kHalf, 0, -kHalf, -1, -kHalf, 0, kHalf};
  const Vec3d along = unit(target.to - target.from), source_along = unit(source.to - source.from);
  const Vec3d any = absolute(along.x) > 0.8 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  const Vec3d first = unit(any - dot(any, along) * along), second = cross(along, first);
  const Quat back = conjugate(source_world);
  const uint32_t begin = count_ * kVertices;
  const auto put = [&](uint32_t v, double at, double side, double cosine, double sine) {
    const Vec3d out = side * (cosine * first + sine * second);
    const Vec3d source_out = rotate(back, rotate(source_from_target, out));
    // `at` counts from the first end, in lengths of the bone; beyond the ends it is a radius.
    const auto point_at = [&](const Bone& bone, Vec3d direction, Vec3d outwards) {
      const double whole = length(bone.to - bone.from);
      const double far = at < 0 ? -bone.radius : at > 1 ? whole + bone.radius : at * whole;
      return bone.from + far * direction + bone.radius * outwards;
    };
    set(target_positions_ + size_t{3} * (begin + v), point_at(target, along, out));
    set(source_positions_ + size_t{3} * (begin + v), point_at(source, source_along, source_out));
    target_joints_[begin + v] = target.joint;
    source_joints_[begin + v] = source.joint;
    weights_[begin + v] = 65535;
  };
  for (uint32_t r = 0; r < kRings; ++r)
    for (uint32_t k = 0; k < kSides; ++k)
      put(kSides * r + k, static_cast<double>(r) / (kRings - 1), 1, kCosines[k], kCosines[(k + 6) % kSides]);
  constexpr uint32_t kFirstPole = kSides * kRings, kLastPole = kFirstPole + 1;
  put(kFirstPole, -1, 0, 0, 0);
  put(kLastPole, 2, 0, 0, 0);
  uint32_t* out = triangles_ + size_t{3} * count_ * kTriangles;
  const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    *out++ = begin + a;
    *out++ = begin + b;
    *out++ = begin + c;
  };
  for (uint32_t k = 0; k < kSides; ++k) {
    const uint32_t next = (k + 1) % kSides, top = kSides * (kRings - 1);
    for (uint32_t r = 0; r + 1 < kRings; ++r) {
      const uint32_t low = kSides * r, high = low + kSides;
      triangle(low + k, low + next, high + next);
      triangle(low + k, high + next, high + k);
    }
    triangle(kFirstPole, next, k);
    triangle(kLastPole, top + k, top + next);
  }
  ++count_;
}

}  // namespace sinew::motion
