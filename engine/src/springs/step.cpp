// SPDX-License-Identifier: MIT
// One step of all chains: the reference algorithm of VRMC_springBone-1.0 (specification, "SpringBone Algorithm"), in doubles of one order.
#include "springs/springs.hpp"

namespace sinew::springs {
namespace {

using motion::conjugate;
using motion::rotate;
using motion::shortest_arc;

Vec3d to_world(const Placement& space, Vec3d v) { return space.position + rotate(space.rotation, v); }
Vec3d to_local(const Placement& space, Vec3d v) { return rotate(conjugate(space.rotation), v - space.position); }

// Where a head's tail is in the head's own axes: the pose of all joints between.
Vec3d tail_in_pose(const SpringState& s, const SpringHead& head, const Placement* pose) {
  Vec3d at;
  for (uint32_t j = head.tail; j != head.joint; j = static_cast<uint32_t>(s.parents[j])) at = to_world(pose[j], at);
  return at;
}

void move_colliders(const SpringState& s, uint32_t joint) {
  for (int32_t c = s.colliders_of[joint]; c >= 0; c = s.colliders[c].next) {
    SpringCollider& one = s.colliders[c];
    one.start = to_world(s.worlds[joint], one.offset);
    if (one.shape == SINEW_COLLIDER_PLANE)
      one.along = unit(rotate(s.worlds[joint].rotation, one.tail));
    else
      one.along = rotate(s.worlds[joint].rotation, one.tail - one.offset);
  }
}

// From the collider's point, or its segment's nearest one, to p.
Vec3d away_from(const SpringCollider& c, Vec3d p) {
  const Vec3d away = p - c.start;
  if (c.shape != SINEW_COLLIDER_CAPSULE && c.shape != SINEW_COLLIDER_INSIDE_CAPSULE) return away;
  const double along = dot(c.along, away), square = dot(c.along, c.along);
  if (along >= square) return away - c.along;
  return along > 0 ? away - (along / square) * c.along : away;
}

// Whether a ball about p is pushed, and to where.
bool push(const SpringCollider& c, double hit_radius, Vec3d* p) {
  const Vec3d away = away_from(c, *p);
  if (c.shape == SINEW_COLLIDER_PLANE) {
    const double distance = dot(away, c.along) - hit_radius;
    if (distance >= 0) return false;
    *p = *p + -distance * c.along;
    return true;
  }
  const double square = dot(away, away);
  if (c.shape == SINEW_COLLIDER_SPHERE || c.shape == SINEW_COLLIDER_CAPSULE) {
    const double reach = hit_radius + c.radius;
    if (square >= reach * reach) return false;
    *p = *p + (reach - root(square)) * unit(away);
    return true;
  }
  const double room = c.radius - hit_radius, distance = root(square);
  if (distance <= room) return false;
  *p = *p - (distance - room) * unit(away);
  return true;
}

// The same along a direction: the nearer of the two points on that line where the ball touches. Shapes that hold it
// inside push as ever.
bool push_along(const SpringCollider& c, double hit_radius, Vec3d line, Vec3d* p) {
  if (c.shape != SINEW_COLLIDER_SPHERE && c.shape != SINEW_COLLIDER_CAPSULE) return push(c, hit_radius, p);
  const Vec3d away = away_from(c, *p);
  const double reach = hit_radius + c.radius, depth = reach * reach - dot(away, away), along = dot(away, line);
  if (depth <= 0) return false;
  const double span = root(along * along + depth);
  *p = *p + (along >= 0 ? span - along : -span - along) * line;
  return true;
}

// Turns a direction about the head to within the limit.
Vec3d limited(const SpringHead& head, Vec3d direction, Vec3d goal) {
  const double along = dot(direction, goal);
  if (!head.limited || along >= head.cosine) return direction;
  Vec3d across = unit(direction - along * goal);
  if (dot(across, across) == 0)
    across = unit(cross(goal, goal.x < 0.9 && goal.x > -0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
  return head.cosine * goal + head.sine * across;
}

// A direction from the head across a hinge's axis, if there is one; where there is none the pose's.
Vec3d direction_to(Vec3d p, Vec3d from, Vec3d goal, Vec3d hinge) {
  const Vec3d way = p - from, direction = unit(way - dot(way, hinge) * hinge);
  return dot(direction, direction) == 0 ? goal : direction;
}

class Step {
 public:
  Step(SpringState* state, const Placement* pose, double share, bool keep)
      : s_(*state), pose_(pose), share_(share), seconds_(share * state->options.step), keep_(keep) {}

  void run() {
    for (uint32_t i = 0; i < s_.order_count; ++i) {
      const uint32_t j = s_.order[i];
      const int32_t parent = s_.parents[j], head = s_.heads_of[j];
      const Placement own = pose_[j];
      Placement& world = s_.worlds[j];
      world = own;
      if (parent >= 0) world = {s_.worlds[parent].rotation * own.rotation, to_world(s_.worlds[parent], own.position)};
      if (head >= 0) {
        const Quat turn = swing(&s_.heads[head], world);
        s_.turned[head] = motion::normalized(own.rotation * turn);
        world.rotation = motion::normalized(world.rotation * turn);
      }
      move_colliders(s_, j);
    }
  }

 private:
  // The rotation of a head in its own axes. world: of the head as the pose has it.
  Quat swing(SpringHead* head, const Placement& world) {
    const Vec3d tail = tail_in_pose(s_, *head, pose_);
    const double length = sinew::length(tail);
    const Vec3d axis = unit(tail), from = world.position, goal = rotate(world.rotation, axis);
    if (dot(axis, axis) == 0) return motion::kNoRotation;
    const SpringChain& chain = s_.chains[head->chain];
    Placement space = {motion::kNoRotation, {}};
    if (chain.center >= 0) space = chain.center == static_cast<int32_t>(head->joint) ? world : s_.worlds[chain.center];
    const double pull = seconds_ * s_.options.unit;
    const Vec3d inertia = rotate(space.rotation, head->current - head->previous);
    const Vec3d next = to_world(space, head->current) + (share_ * head->keep) * inertia +
                       (pull * head->stiffness) * goal + (pull * head->gravity_power) * head->gravity;
    const Vec3d turns = rotate(world.rotation, head->hinge), hinge = unit(turns - dot(turns, goal) * goal);
    const bool hinged = dot(hinge, hinge) > 0;
    Vec3d direction = limited(*head, direction_to(next, from, goal, hinge), goal);
    Vec3d p = from + length * direction;
    for (uint32_t i = 0; i < chain.collider_count; ++i) {
      const SpringCollider& collider = s_.colliders[s_.chain_colliders[chain.first_collider + i]];
      const bool pushed = hinged ? push_along(collider, head->hit_radius, cross(hinge, direction), &p)
                                 : push(collider, head->hit_radius, &p);
      if (!pushed) continue;
      direction = direction_to(p, from, goal, hinge);
      p = from + length * direction;
    }
    if (keep_) {
      head->previous = head->current;
      head->current = to_local(space, p);
    }
    return shortest_arc(axis, rotate(conjugate(world.rotation), direction));
  }

  SpringState& s_;
  const Placement* pose_;
  double share_, seconds_;
  bool keep_;
};

}  // namespace

void step(SpringState* state, const Placement* pose, double share, bool keep) { Step(state, pose, share, keep).run(); }

void settle(SpringState* s, const Placement* pose) {
  for (uint32_t i = 0; i < s->order_count; ++i) {
    const uint32_t j = s->order[i];
    const int32_t parent = s->parents[j];
    s->worlds[j] = pose[j];
    if (parent >= 0)
      s->worlds[j] = {motion::normalized(s->worlds[parent].rotation * pose[j].rotation),
                      to_world(s->worlds[parent], pose[j].position)};
    move_colliders(*s, j);
  }
  for (uint32_t h = 0; h < s->head_count; ++h) {
    SpringHead& head = s->heads[h];
    const int32_t center = s->chains[head.chain].center;
    const Vec3d tail = to_world(s->worlds[head.joint], tail_in_pose(*s, head, pose));
    head.current = head.previous = center < 0 ? tail : to_local(s->worlds[center], tail);
    s->turned[h] = pose[head.joint].rotation;
  }
}

}  // namespace sinew::springs
