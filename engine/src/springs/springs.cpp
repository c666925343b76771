// SPDX-License-Identifier: MIT
// Reads chains and colliders, and plays frames: how many steps one takes, and at which poses.
#include "springs/springs.hpp"

#include <stddef.h>

#include "core/struct_size.hpp"
#include "motion/motion_rig.hpp"

namespace sinew::springs {
namespace {

using motion::is_finite;
using motion::kNoRotation;

constexpr double kSnap = 1e-3;  // share of a step that counts as none: times of frames are floats

Vec3d vector_of(const float (&v)[3]) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

sinew_status read_head(const sinew_spring_joint& in, SpringHead* out) {
  const double values[] = {static_cast<double>(in.hit_radius), static_cast<double>(in.stiffness),
                           static_cast<double>(in.gravity_power), static_cast<double>(in.drag),
                           static_cast<double>(in.limit)};
  const Vec3d gravity = vector_of(in.gravity);
  double sum = gravity.x + gravity.y + gravity.z;
  for (const double value : values) sum += value;
  if (!is_finite(sum)) return SINEW_ERROR_NOT_FINITE;
  if (in.hit_radius < 0 || in.stiffness < 0 || !(in.drag >= 0 && in.drag <= 1) || !(in.limit >= 0 && in.limit <= 180))
    return SINEW_ERROR_RANGE;
  out->hit_radius = values[0];
  out->stiffness = values[1];
  out->gravity_power = values[2];
  out->keep = 1 - values[3];
  out->gravity = unit(gravity);
  out->limited = in.limit > 0;
  if (out->limited) cosine_and_sine(values[4], &out->cosine, &out->sine);
  return SINEW_OK;
}

sinew_status read_collider(const sinew_spring_collider& in, uint32_t joint_count, SpringCollider* out) {
  const Vec3d offset = vector_of(in.offset), tail = vector_of(in.tail);
  const double radius = static_cast<double>(in.radius);
  if (!is_finite(offset.x + offset.y + offset.z + tail.x + tail.y + tail.z + radius)) return SINEW_ERROR_NOT_FINITE;
  if (in.joint >= joint_count) return SINEW_ERROR_INDEX;
  if (in.shape < SINEW_COLLIDER_SPHERE || in.shape > SINEW_COLLIDER_PLANE) return SINEW_ERROR_ARGUMENT;
  if (in.shape != SINEW_COLLIDER_PLANE && in.radius < 0) return SINEW_ERROR_RANGE;
  *out = SpringCollider();
  out->joint = in.joint;
  out->shape = in.shape;
  out->offset = offset;
  out->tail = tail;
  out->radius = in.shape == SINEW_COLLIDER_PLANE ? 0 : radius;
  return SINEW_OK;
}

bool is_below(const int32_t* parents, uint32_t joint, uint32_t above) {
  for (int32_t at = parents[joint]; at >= 0; at = parents[at])
    if (at == static_cast<int32_t>(above)) return true;
  return false;
}

sinew_status fill_joints(const sinew_skeleton& skeleton, SpringState* s) {
  const uint32_t joints = skeleton.joint_count;
  Vec3d low, high;
  for (uint32_t j = 0; j < joints; ++j) {
    const float* const p = skeleton.positions + size_t{3} * j;
    const Vec3d at = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    if (!is_finite(at.x + at.y + at.z)) return SINEW_ERROR_NOT_FINITE;
    if (j == 0) low = high = at;
    low = {lesser(low.x, at.x), lesser(low.y, at.y), lesser(low.z, at.z)};
    high = {greater(high.x, at.x), greater(high.y, at.y), greater(high.z, at.z)};
    s->parents[j] = skeleton.parents[j];
    if (s->parents[j] < -1 || s->parents[j] >= static_cast<int32_t>(joints)) return SINEW_ERROR_INDEX;
    s->heads_of[j] = s->colliders_of[j] = -1;
    s->worlds[j] = s->before[j] = s->now[j] = s->between[j] = {kNoRotation, {}};
  }
  for (uint32_t j = 0; j < joints; ++j) {
    uint32_t depth = 0;
    for (int32_t at = s->parents[j]; at >= 0; at = s->parents[at])
      if (++depth >= joints) return SINEW_ERROR_HIERARCHY;
  }
  if (s->options.teleport == 0) {
    const Vec3d side = high - low;
    s->options.teleport = greater(side.x, greater(side.y, side.z));
  }
  return SINEW_OK;
}

// The heads of one chain.
sinew_status fill_chain(const sinew_spring_set& set, uint32_t chain, SpringState* s) {
  const sinew_spring_chain& in = set.chains[chain];
  const uint32_t joints = s->counts.skeleton_joints;
  if (in.joint_count < 2) return SINEW_ERROR_COUNT;
  if (in.first_joint > set.joint_count || in.joint_count > set.joint_count - in.first_joint ||
      in.first_collider > set.chain_collider_count ||
      in.collider_count > set.chain_collider_count - in.first_collider || in.center < -1 ||
      in.center >= static_cast<int32_t>(joints)) {
    return SINEW_ERROR_INDEX;
  }
  s->chains[chain] = {in.first_collider, in.collider_count, in.center};
  for (uint32_t i = 0; i < in.joint_count; ++i)
    if (set.joints[in.first_joint + i].joint >= joints) return SINEW_ERROR_INDEX;
  for (uint32_t i = 0; i + 1 < in.joint_count; ++i) {
    const sinew_spring_joint& one = set.joints[in.first_joint + i];
    SpringHead head;
    const sinew_status status = read_head(one, &head);
    if (status != SINEW_OK) return status;
    head.joint = one.joint;
    head.tail = set.joints[in.first_joint + i + 1].joint;
    head.chain = chain;
    if (set.hinges != nullptr) {
      const float* const axis = set.hinges + size_t{3} * (in.first_joint + i);
      head.hinge = {static_cast<double>(axis[0]), static_cast<double>(axis[1]), static_cast<double>(axis[2])};
      if (!is_finite(head.hinge.x + head.hinge.y + head.hinge.z)) return SINEW_ERROR_NOT_FINITE;
    }
    if (!is_below(s->parents, head.tail, head.joint) || s->heads_of[head.joint] >= 0) return SINEW_ERROR_CHAIN;
    if (s->head_count == s->counts.joints) return SINEW_ERROR_CHAIN;  // chains share their joints
    s->heads_of[head.joint] = static_cast<int32_t>(s->head_count);
    s->heads[s->head_count++] = head;
  }
  return SINEW_OK;
}

void read_pose(const SpringState& s, const float* rotations, const float* translations, Placement* pose) {
  for (uint32_t i = 0; i < s.order_count; ++i) {
    const uint32_t j = s.order[i];
    const float* const q = rotations + size_t{4} * j;
    const float* const t = translations + size_t{3} * j;
    pose[j] = {motion::normalized({static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
                                   static_cast<double>(q[3])}),
               {static_cast<double>(t[0]), static_cast<double>(t[1]), static_cast<double>(t[2])}};
  }
}

// The pose between the last frame's and this one's.
const Placement* pose_between(const SpringState& s, double share) {
  if (share >= 1) return s.now;
  for (uint32_t i = 0; i < s.order_count; ++i) {
    const uint32_t j = s.order[i];
    const Quat a = s.before[j].rotation, b = s.now[j].rotation;
    const double same = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    const double from = 1 - share, to = same < 0 ? -share : share;
    s.between[j] = {motion::normalized(
                        {from * a.x + to * b.x, from * a.y + to * b.y, from * a.z + to * b.z, from * a.w + to * b.w}),
                    from * s.before[j].position + share * s.now[j].position};
  }
  return s.between;
}

// Roots may be translated, or hips below a root; other joints keep their translations.
bool has_jumped(const SpringState& s) {
  for (uint32_t i = 0; i < s.order_count; ++i) {
    const uint32_t j = s.order[i];
    const Vec3d moved = s.now[j].position - s.before[j].position;
    if (dot(moved, moved) > s.options.teleport * s.options.teleport) return true;
  }
  return false;
}

}  // namespace

sinew_status SpringCounts::check() const {
  const bool fits = skeleton_joints > 0 && skeleton_joints <= SINEW_MAX_JOINTS && joints > 0 &&
                    joints <= SINEW_MAX_JOINTS && chains > 0 && chains <= joints && colliders <= SINEW_MAX_JOINTS &&
                    chain_colliders <= SINEW_MAX_CHAIN_COLLIDERS;
  return fits ? SINEW_OK : SINEW_ERROR_COUNT;
}

sinew_status read_springs_options(const sinew_springs_options* options, SpringOptions* out) {
  sinew_springs_options o = SINEW_INIT(sinew_springs_options);
  const sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, sizeof o, sizeof o, &o);
  if (status != SINEW_OK) return status;
  if (o.reserved != 0) return SINEW_ERROR_VERSION;
  const double steps = static_cast<double>(o.steps), unit = static_cast<double>(o.unit);
  const double teleport = static_cast<double>(o.teleport), gap = static_cast<double>(o.gap);
  if (!is_finite(steps + unit + teleport + gap)) return SINEW_ERROR_NOT_FINITE;
  if ((steps != 0 && !(steps >= 10 && steps <= 1000)) || unit < 0 || teleport < 0 || !(gap >= 0 && gap <= 10))
    return SINEW_ERROR_ARGUMENT;
  *out = SpringOptions();
  if (steps != 0) out->step = 1 / steps;
  if (unit != 0) out->unit = unit;
  out->teleport = teleport;
  if (gap != 0) out->gap = gap;
  return SINEW_OK;
}

bool SpringState::allocate(Arena& arena) {
  const uint32_t j = counts.skeleton_joints;
  parents = arena.alloc<int32_t>(j);
  order = arena.alloc<uint32_t>(j);
  heads_of = arena.alloc<int32_t>(j);
  colliders_of = arena.alloc<int32_t>(j);
  heads = arena.alloc<SpringHead>(counts.joints);
  chains = arena.alloc<SpringChain>(counts.chains);
  colliders = arena.alloc<SpringCollider>(counts.colliders);
  chain_colliders = arena.alloc<uint32_t>(counts.chain_colliders);
  before = arena.alloc<Placement>(j);
  now = arena.alloc<Placement>(j);
  between = arena.alloc<Placement>(j);
  worlds = arena.alloc<Placement>(j);
  turned = arena.alloc<Quat>(counts.joints);
  return arena.ok();
}

sinew_status fill(const sinew_skeleton& skeleton, const sinew_spring_set& set, SpringState* s) {
  sinew_status status = fill_joints(skeleton, s);
  if (status != SINEW_OK) return status;
  for (uint32_t c = set.collider_count; c-- > 0;) {
    status = read_collider(set.colliders[c], skeleton.joint_count, &s->colliders[c]);
    if (status != SINEW_OK) return status;
    s->colliders[c].next = s->colliders_of[s->colliders[c].joint];
    s->colliders_of[s->colliders[c].joint] = static_cast<int32_t>(c);
  }
  for (uint32_t i = 0; i < set.chain_collider_count; ++i) {
    s->chain_colliders[i] = set.chain_colliders[i];
    if (s->chain_colliders[i] >= set.collider_count) return SINEW_ERROR_INDEX;
  }
  for (uint32_t chain = 0; chain < set.chain_count; ++chain) {
    status = fill_chain(set, chain, s);
    if (status != SINEW_OK) return status;
  }
  // The poses' memory is not in use yet, and has more bytes than a joint needs here.
  sort_joints(s, reinterpret_cast<uint8_t*>(s->between), reinterpret_cast<uint8_t*>(s->before));
  return SINEW_OK;
}

void play_frame(SpringState* s, double seconds, const float* rotations, const float* translations,
                float* out_rotations) {
  read_pose(*s, rotations, translations, s->now);
  const bool restarts = !s->started || seconds > s->options.gap || has_jumped(*s);
  for (size_t i = 0; i < size_t{4} * s->counts.skeleton_joints; ++i) out_rotations[i] = rotations[i];
  if (restarts) {
    settle(s, s->now);
    s->started = true;
    s->time = 0;
  } else {
    const double length = s->options.step;
    s->time += seconds;
    bool shown = false;
    while (s->time >= (1 - kSnap) * length) {
      s->time -= length;
      if (s->time < kSnap * length) s->time = 0;
      shown = s->time == 0;
      step(s, pose_between(*s, shown ? 1 : (seconds - s->time) / seconds), 1, true);
    }
    if (!shown) step(s, s->now, s->time / length, false);
    for (uint32_t h = 0; h < s->head_count; ++h) {
      const Quat q = s->turned[h];
      float* const out = out_rotations + size_t{4} * s->heads[h].joint;
      out[0] = static_cast<float>(q.x);
      out[1] = static_cast<float>(q.y);
      out[2] = static_cast<float>(q.z);
      out[3] = static_cast<float>(q.w);
    }
  }
  Placement* const last = s->before;
  s->before = s->now;
  s->now = last;
}

}  // namespace sinew::springs
