// SPDX-License-Identifier: MIT
// Limbs by their classes; a stance by lengths and by the mirror plane between the legs.
#include "motion/upright_body.hpp"

#include <algorithm>
#include <cmath>

#include "sinew/rig.h"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

class BodyFinder {
 public:
  BodyFinder(const std::vector<Joint>& joints, const std::vector<uint8_t>& classes)
      : joints_(joints), classes_(classes), tree_(joints), reach_(joints.size(), 0) {
    for (size_t k = tree_.parents_first.size(); k-- > 0;) {
      const int joint = static_cast<int>(tree_.parents_first[k]), up = parent(joint);
      if (up < 0) continue;
      double& own = reach_[static_cast<size_t>(up)];
      own = std::max(own, reach_from_parent(joint));
    }
  }

  std::vector<UprightLimb> legs() const { return limbs(SINEW_CLASS_THIGH, SINEW_CLASS_CALF, SINEW_CLASS_FOOT); }
  std::vector<UprightLimb> arms() const { return limbs(SINEW_CLASS_UPPER_ARM, SINEW_CLASS_FOREARM, SINEW_CLASS_HAND); }

  std::optional<UprightBody> find() const {
    UprightBody body;
    const std::vector<UprightLimb> legs = this->legs(), arms = this->arms();
    if (legs.size() != 2) return std::nullopt;
    body.legs = {legs[0], legs[1]};
    body.hips = common(legs[0].upper, legs[1].upper);
    if (body.hips < 0) return std::nullopt;
    for (UprightLimb& leg : body.legs) leave_hips(body.hips, &leg);
    body.has_arms = arms.size() == 2;
    if (body.has_arms) body.arms = {arms[0], arms[1]};
    for (size_t j = 0; j < joints_.size() && body.head < 0; ++j)
      if (classes_[j] == SINEW_CLASS_HEAD && !has_above(static_cast<int>(j), SINEW_CLASS_HEAD))
        body.head = static_cast<int>(j);
    if (body.has_arms)
      body.chest = common(arms[0].upper, arms[1].upper);
    else if (body.head >= 0)
      body.chest = joints_[static_cast<size_t>(body.head)].parent;
    if (body.chest < 0) return std::nullopt;
    give_sides(&body);
    return body;
  }

 private:
  uint8_t class_of(int joint) const { return classes_[static_cast<size_t>(joint)]; }
  int parent(int joint) const { return joints_[static_cast<size_t>(joint)].parent; }
  bool has_above(int joint, uint8_t wanted) const {
    for (int up = parent(joint); up >= 0; up = parent(up))
      if (class_of(up) == wanted) return true;
    return false;
  }
  int common(int a, int b) const {
    std::vector<char> above(joints_.size(), 0);
    for (int x = a; x >= 0; x = parent(x)) above[static_cast<size_t>(x)] = 1;
    while (b >= 0 && above[static_cast<size_t>(b)] == 0) b = parent(b);
    return b;
  }
  // The nearest joint below of a class, -1 = none.
  int first_below(int joint, uint8_t wanted) const {
    std::vector<int> queue = tree_.children[static_cast<size_t>(joint)];
    for (size_t i = 0; i < queue.size(); ++i) {
      if (class_of(queue[i]) == wanted) return queue[i];
      const std::vector<int>& below = tree_.children[static_cast<size_t>(queue[i])];
      queue.insert(queue.end(), below.begin(), below.end());
    }
    return -1;
  }
  // The first joint at another position on the longest path down.
  int tip_of(int joint) const {
    int at = joint;
    while (at >= 0 && !(distance(joint, at) > 0)) {
      int best = -1;
      for (const int child : tree_.children[static_cast<size_t>(at)])
        if (best < 0 || reach_from_parent(child) > reach_from_parent(best)) best = child;
      at = best;
    }
    return at;
  }
  double distance(int from, int to) const {
    const Vec3 &a = joints_[static_cast<size_t>(from)].position, &b = joints_[static_cast<size_t>(to)].position;
    return length({double{b.x} - double{a.x}, double{b.y} - double{a.y}, double{b.z} - double{a.z}});
  }
  // A leg that begins where the hips are begins at its next joint.
  void leave_hips(int hips, UprightLimb* leg) const {
    double way = 0;
    for (int at = leg->upper; at != hips; at = parent(at)) way += distance(parent(at), at);
    int next = leg->middle;
    while (parent(next) != leg->upper) next = parent(next);
    if (!(way > 0) && next != leg->middle) leg->upper = next;
  }
  double reach_from_parent(int joint) const {
    return reach_[static_cast<size_t>(joint)] + distance(parent(joint), joint);
  }
  std::vector<UprightLimb> limbs(uint8_t upper, uint8_t middle, uint8_t end) const {
    std::vector<UprightLimb> found;
    for (size_t j = 0; j < joints_.size(); ++j) {
      const int joint = static_cast<int>(j);
      if (classes_[j] != upper || has_above(joint, upper)) continue;
      UprightLimb limb = {joint, first_below(joint, middle), -1, -1};
      if (limb.middle < 0) continue;
      limb.end = first_below(limb.middle, end);
      if (limb.end < 0) limb.end = tip_of(limb.middle);
      if (limb.end < 0) continue;
      limb.tip = tip_of(limb.end);
      found.push_back(limb);
    }
    return found;
  }
  void give_sides(UprightBody* body) const {
    const auto side = [&](const UprightLimb& limb) {
      return side_of_name(joints_[static_cast<size_t>(limb.upper)].name);
    };
    body->sided = side(body->legs[0]) != Side::kNone && side(body->legs[1]) != Side::kNone &&
                  side(body->legs[0]) != side(body->legs[1]);
    if (!body->sided) return;
    if (side(body->legs[0]) == Side::kRight) std::swap(body->legs[0], body->legs[1]);
    if (body->has_arms && side(body->arms[0]) == Side::kRight) std::swap(body->arms[0], body->arms[1]);
  }

  const std::vector<Joint>& joints_;
  const std::vector<uint8_t>& classes_;
  JointTree tree_;
  std::vector<double> reach_;  // [J] length of the longest path down
};

}  // namespace

std::vector<UprightLimb> find_limbs(const std::vector<Joint>& joints, const std::vector<uint8_t>& classes, bool legs) {
  const BodyFinder finder(joints, classes);
  return legs ? finder.legs() : finder.arms();
}

std::optional<UprightBody> find_upright_body(const std::vector<Joint>& joints, const std::vector<uint8_t>& classes) {
  return BodyFinder(joints, classes).find();
}

bool is_upright(const UprightBody& body, const std::vector<Point3>& positions) {
  constexpr double kStretched = 0.5;  // of a limb's length, the least that it reaches
  constexpr double kAbove = 0.4;      // of a leg, the chest or the head over the hips
  constexpr double kLean = 0.25;      // tangent of a torso's lean, the most
  constexpr double kApart = 0.03;     // of a leg, where legs begin
  constexpr double kMirrored = 0.06;  // of a leg, mean distance from mirror images: of 278 rigs at rest 0.050 at most
  const auto at = [&](int joint) { return positions[static_cast<size_t>(joint)]; };
  const auto span = [&](int a, int b) { return length(at(b) - at(a)); };
  const auto limb_length = [&](const UprightLimb& l) { return span(l.upper, l.middle) + span(l.middle, l.end); };
  const double leg = 0.5 * (limb_length(body.legs[0]) + limb_length(body.legs[1]));
  if (!(leg > 0)) return false;
  Point3 up = unit(at(body.legs[0].upper) - at(body.legs[0].end)) + unit(at(body.legs[1].upper) - at(body.legs[1].end));
  size_t axis = 0;
  for (size_t i = 1; i < 3; ++i) axis = std::abs(up[i]) > std::abs(up[axis]) ? i : axis;
  if (!(up[axis] > 0)) return false;  // upside down
  up = {};
  up[axis] = 1;
  for (const UprightLimb& limb : body.legs)
    if (dot(at(limb.upper) - at(limb.end), up) < kStretched * limb_length(limb)) return false;
  const Point3 middle = 0.5 * (at(body.legs[0].upper) + at(body.legs[1].upper));
  const double top = dot(at(body.chest) - middle, up);
  if (std::max(top, body.head >= 0 ? dot(at(body.head) - middle, up) : top) < kAbove * leg) return false;
  if (length(across(at(body.chest) - middle, up)) > kLean * std::max(0.0, top)) return false;
  const Point3 side = at(body.legs[0].upper) - at(body.legs[1].upper);
  if (length(across(side, up)) < kApart * leg || std::abs(dot(unit(side), up)) > 0.3) return false;
  const Point3 normal = unit(across(side, up));
  double off = 0, count = 0;
  const auto compare = [&](int left, int right) {
    if (left < 0 || right < 0) return;
    const Point3 from = at(left) - middle, image = from - 2 * dot(from, normal) * normal;
    off += length(image - (at(right) - middle));
    count += 1;
  };
  const auto compare_limbs = [&](const std::array<UprightLimb, 2>& limbs) {
    compare(limbs[0].upper, limbs[1].upper);
    compare(limbs[0].middle, limbs[1].middle);
    compare(limbs[0].end, limbs[1].end);
  };
  compare_limbs(body.legs);
  if (body.has_arms) {
    compare_limbs(body.arms);
    for (const UprightLimb& arm : body.arms)
      if (span(arm.upper, arm.end) < kStretched * limb_length(arm)) return false;
  }
  return off < kMirrored * leg * count;
}

// By toes, by names, and by what is bent at rest.
BodyFrame body_frame(const std::vector<Joint>& joints, const UprightBody& body, MaybeAxis up) {
  const auto at = [&](int j) { return point(joints[static_cast<size_t>(j)].position); };
  BodyFrame frame;
  const auto& legs = body.legs;
  const Point3 hips = 0.5 * (at(legs[0].upper) + at(legs[1].upper));
  const Point3 rise = hips - 0.5 * (at(legs[0].end) + at(legs[1].end));
  size_t axis = up ? axis_index(*up) : 3;
  for (size_t i = 0; i < 3 && !up; ++i)
    if (axis == 3 || std::abs(rise[i]) > std::abs(rise[axis])) axis = i;
  frame.up[axis] = rise[axis] < 0 && !up ? -1 : 1;
  Point3 toes{};
  for (const UprightLimb& leg : legs)
    if (leg.tip >= 0) toes = toes + across(at(leg.tip) - at(leg.end), frame.up);
  const Point3 side = across(at(legs[0].upper) - at(legs[1].upper), frame.up);
  const Point3 by_names = cross(side, frame.up);
  const bool toed = length(toes) > 0.1 * length(rise);
  if (body.sided && (!toed || dot(toes, by_names) > 0))
    frame.front = unit(by_names);
  else if (toed)
    frame.front = unit(across(toes, unit(side)));
  frame.left = length(frame.front) > 0 ? cross(frame.up, frame.front) : unit(side);
  frame.middle = hips;
  return frame;
}

std::optional<Point3> bend_side(const Point3& along, const Point3& own, const Point3& front, bool calf) {
  constexpr double kLeastBend = 0.0871557427476582;  // sine of 5 degrees, as sinew_retarget_keep_range() has it
  constexpr double kLeastFront = 0.3;                // of a unit vector: less of it lies across the bone
  const Point3 by_front = across(calf ? -1.0 * front : front, along), by_rest = across(own, along);
  if (length(by_rest) > kLeastBend && (length(by_front) < kLeastFront || dot(by_rest, by_front) > 0)) return by_rest;
  return length(by_front) < kLeastFront ? std::nullopt : std::optional<Point3>(by_front);
}

}  // namespace sinew
