// SPDX-License-Identifier: MIT
// Where a limb goes on and where it ends: the child that carries most, or reaches much further than the others.
#include "mapping/limbs.hpp"

namespace sinew::mapping {

bool Limbs::allocate(Arena& arena, uint32_t rig_joints) {
  // A joint is in one limb off the torso and, below a chain in the plane, in another. What is appended is copied, as long
  // as there is room. A limb has a point more than joints.
  joints_room = static_cast<int32_t>(4 * rig_joints);
  kept_room = static_cast<int32_t>(rig_joints);
  at = arena.alloc<Limb>(kMostLimbs);
  pairs = arena.alloc<LimbPair>(kMostSideLimbs);
  joints = arena.alloc<int32_t>(static_cast<size_t>(joints_room));
  points = arena.alloc<Point>(static_cast<size_t>(joints_room + kMostLimbs));
  return arena.ok();
}

Point Limbs::mean_point(const Limb& limb) const {
  Point sum;
  for (int32_t k = 0; k < limb.point_count; ++k) sum = sum + point(limb, k);
  return (1.0 / limb.point_count) * sum;
}

double Limbs::lowest(const Limb& limb, const Point& up) const {
  double low = dot(point(limb, 0), up);
  for (int32_t k = 1; k < limb.point_count; ++k) low = lesser(low, dot(point(limb, k), up));
  return low;
}

bool Limbs::is_twist(const Limb& limb, int32_t sub) const {
  const Limb& own = at[sub];
  for (int32_t k = 0; k + 1 < limb.joint_count; ++k) {
    if (joint(limb, k) != own.attach) continue;
    const Point start = point(limb, k), bone = point(limb, k + 1) - start;
    const double squared = dot(bone, bone);
    if (!(squared > 0.0064 * limb.length * limb.length)) return false;
    const Point path = point(own, 0) - start;
    const double share = dot(path, bone) / squared;
    const Point off = path - share * bone;
    return share > -0.05 && share < 0.97 && dot(off, off) < 0.01 * squared;
  }
  return false;
}

int32_t Limbs::begin(const Hierarchy& rig, int32_t joint, int8_t side, int32_t attach) {
  if (count >= kMostLimbs) {
    full = true;
    return -1;
  }
  Limb& limb = at[count];
  limb = Limb();
  limb.side = side;
  limb.attach = attach;
  limb.tree = rig.count[joint];
  limb.first_joint = joint;  // until its chain is followed
  return count++;
}

namespace {

// Whether a limb may go on or branch there: no end marker, and of a chain in the plane nothing beside it, which is a limb
// of its own.
bool is_limb_kid(const Hierarchy& rig, const int8_t* side, int32_t joint, int32_t kid) {
  return rig.end[kid] == 0 && side[kid] == side[joint];
}

bool has_limb_kid(const Hierarchy& rig, int32_t joint) {
  for (int32_t k = 0; k < rig.kid_count(joint); ++k) {
    if (rig.end[rig.kid(joint, k)] == 0) return true;
  }
  return false;
}

// The only child that is called as a long bone's end is, such as a hand beside a thumb of as many joints; -1 = none.
int32_t named_kid(const Hierarchy& rig, const int8_t* side, int32_t joint) {
  int32_t found = -1, count = 0;
  each_kid(rig, joint, [&](int32_t k) {
    if (!rig.has_names || !is_limb_kid(rig, side, joint, k)) return;
    const Part part = names::limb_part(rig.part(k));
    if (part != Part::kLowerArm && part != Part::kHand && part != Part::kLowLeg && part != Part::kFoot) return;
    found = k;
    ++count;
  });
  return count == 1 ? found : -1;
}

// The child that carries most, or reaches furthest of those; -1 = none. `leads`: it carries or reaches so much more than
// the others that a limb goes on with it.
int32_t first_kid(const Hierarchy& rig, const int8_t* side, int32_t joint, bool* leads) {
  int32_t first = -1, all = 0;
  each_kid(rig, joint, [&](int32_t k) {
    if (!is_limb_kid(rig, side, joint, k)) return;
    all += rig.count[k];
    const bool before = first >= 0 && (rig.count[first] > rig.count[k] ||
                                       (rig.count[first] == rig.count[k] && rig.reach[first] >= rig.reach[k]));
    if (!before) first = k;
  });
  *leads = false;
  if (first < 0) return first;
  double other = 0, gap = 0;
  int32_t kids = 0;
  each_kid(rig, joint, [&](int32_t k) {
    if (!is_limb_kid(rig, side, joint, k)) return;
    ++kids;
    if (k == first) return;
    other = greater(other, rig.reach[k] + rig.bone(joint, k));
    gap = greater(gap, rig.bone(first, k));
  });
  const int32_t own = rig.count[first], rest = all - own;
  const double path = rig.reach[first] + rig.bone(joint, first);
  *leads = own >= 2 * rest || (own > rest && path > 2.5 * other) || path > 4 * other;
  // A thumb that begins where the hand does.
  if (kids == 2 && own > rest && gap < 0.02 * rig.bone(joint, first)) *leads = true;
  // A hand with its fingers, and a thumb of as many joints on the same spot: the hand goes on where the arm points.
  if (kids == 2 && own == rest && own >= 2 && gap < 0.02 * rig.bone(joint, first)) {
    const auto in_line = [&](int32_t k) {
      return rig.kid_count(k) > 0
                 ? dot(direction(rig.at[k] - rig.at[joint]), direction(rig.at[rig.kid(k, 0)] - rig.at[k]))
                 : -1;
    };
    each_kid(rig, joint, [&](int32_t k) {
      if (is_limb_kid(rig, side, joint, k) && in_line(k) > in_line(first) + 1e-9) first = k;
    });
    *leads = true;
  }
  // A tail with fins of a joint or two.
  if (side[joint] == 0 && own > rest && path > 1.2 * other) *leads = true;
  if (side[joint] == 0 && !*leads &&
      rig.parent[joint] >= 0) {  // of fins and a tail of as many joints, what is straight on
    const Point ahead = direction(rig.at[joint] - rig.at[rig.parent[joint]]);
    const auto straight = [&](int32_t k) { return dot(ahead, direction(rig.at[k] - rig.at[joint])); };
    int32_t best = first;
    each_kid(rig, joint, [&](int32_t k) {
      if (is_limb_kid(rig, side, joint, k) && rig.count[k] == own && straight(k) > straight(best) + 1e-9) best = k;
    });
    if (own > 1 && straight(best) > 0.95) {
      first = best;
      *leads = true;
    }
  }
  const int32_t called = named_kid(rig, side, joint);
  if (called >= 0) *leads = true;
  return called >= 0 ? called : first;
}

}  // namespace

void Limbs::follow(const Hierarchy& rig, const int8_t* side, int32_t number) {
  Limb& limb = at[number];
  int32_t i = limb.first_joint;
  limb.first_joint = joints_used;
  limb.first_point = points_used;
  for (;;) {
    joints[joints_used++] = i;
    points[points_used++] = rig.at[i];
    ++limb.joint_count;
    bool leads = false;
    const int32_t next = first_kid(rig, side, i, &leads);
    if (next < 0) break;
    if (!leads) break;
    i = next;
  }
  limb.point_count = limb.joint_count;
  // Branches in the order of the chain.
  int32_t tail = -1;
  for (int32_t k = 0; k < limb.joint_count; ++k) {
    const int32_t j = joint(limb, k), next = k + 1 < limb.joint_count ? joint(limb, k + 1) : -1;
    each_kid(rig, j, [&](int32_t kid) {
      if (kid == next || !is_limb_kid(rig, side, j, kid)) return;
      const int32_t sub = begin(rig, kid, limb.side, j);
      if (sub < 0) return;
      (tail < 0 ? limb.first_sub : at[tail].next) = sub;
      tail = sub;
    });
  }
  const auto add_point = [&](const Point& p) {
    points[points_used++] = p;
    ++limb.point_count;
  };
  const int32_t last = last_joint(limb);
  if (!has_limb_kid(rig, last) && rig.kid_count(last) == 1) add_point(rig.at[rig.kid(last, 0)]);
  int32_t fingers = 0;
  Point sum;
  for (int32_t t = limb.first_sub; t >= 0; t = at[t].next) {
    if (at[t].attach != last) continue;
    ++fingers;
    sum = sum + rig.at[at[t].first_joint];  // still its first joint's number
  }
  if (fingers >= 2 && limb.joint_count >= 2) {  // fingers far away from the last joint: a hand that is no joint
    const Point hand = (1.0 / fingers) * sum;
    if (distance(hand, rig.at[last]) > 0.5 * rig.bone(joint(limb, limb.joint_count - 2), last)) {
      add_point(hand);
      limb.has_hand = true;
    }
  }
  for (int32_t k = 1; k < limb.point_count; ++k) limb.length += distance(point(limb, k - 1), point(limb, k));
}

void Limbs::grow(const Hierarchy& rig, const int8_t* side, int32_t from) {
  for (int32_t k = from; k < count; ++k) follow(rig, side, k);  // `count` grows in the loop
}

void Limbs::append(int32_t number, int32_t foot) {
  Limb& limb = at[number];
  const Limb& more = at[foot];
  const int32_t all = limb.joint_count + more.joint_count, all_points = limb.joint_count + more.point_count;
  if (joints_used + all + kept_room > joints_room) return;
  const int32_t first_joint = joints_used, first_point = points_used;
  for (int32_t k = 0; k < limb.joint_count; ++k) {
    joints[joints_used++] = joint(limb, k);
    points[points_used++] = point(limb, k);  // without the point beyond its last joint
  }
  for (int32_t k = 0; k < more.joint_count; ++k) joints[joints_used++] = joint(more, k);
  for (int32_t k = 0; k < more.point_count; ++k) points[points_used++] = point(more, k);
  limb.first_joint = first_joint;
  limb.joint_count = all;
  limb.first_point = first_point;
  limb.point_count = all_points;
  int32_t tail = -1;
  each_sub(limb, [&](int32_t t) { tail = t; });
  (tail < 0 ? limb.first_sub : at[tail].next) = more.first_sub;
  limb.has_hand = false;
  limb.length = 0;
  for (int32_t k = 1; k < limb.point_count; ++k) limb.length += distance(point(limb, k - 1), point(limb, k));
}

}  // namespace sinew::mapping
