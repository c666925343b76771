// SPDX-License-Identifier: MIT
// Hard ends of a human body's joints by their classes. Angles are those of joint ranges in ergonomics, and then some: a limit is there
// for what no body does.
#include <algorithm>
#include <optional>

#include "motion/upright_body.hpp"
#include "sinew/rig.h"
#include "sinew_character/motion/joint_limits.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

struct Ends {
  float least, most;  // degrees
};
// A ball: twist about the bone, then swings about `side` and bone x side.
struct Ball {
  Ends twist, first, second;
};

constexpr Ball kSpine = {{-45, 45}, {-50, 50}, {-45, 45}};
constexpr Ball kNeck = {{-65, 65}, {-55, 55}, {-50, 50}};
constexpr Ball kHeadBall = {{-80, 80}, {-65, 65}, {-55, 55}};
constexpr Ball kClavicle = {{-45, 45}, {-45, 45}, {-45, 45}};
constexpr Ball kHand = {{-110, 110}, {-90, 90}, {-90, 90}};
constexpr Ball kFoot = {{-50, 50}, {-65, 65}, {-50, 50}};
// From straight down: bent forward is negative about the body's left, away from the other leg positive about the front for a left one.
constexpr Ball kThigh = {{-70, 70}, {-140, 40}, {-45, 75}};
// From straight aside: to the front is negative about up for a left one, up positive.
constexpr Ball kUpperArm = {{-120, 120}, {-150, 60}, {-105, 120}};
// From the straight limb: to the side where it bends.
constexpr Ball kCalf = {{-50, 50}, {-10, 160}, {-20, 20}};
constexpr Ball kForearm = {{-130, 130}, {-15, 160}, {-40, 40}};

class HumanLimits {
 public:
  HumanLimits(const MapRig& target, MaybeAxis up)
      : joints_(target.joints), classes_(limb_classes(target, up)), next_(joints_.size(), -1) {
    const std::optional<UprightBody> body = find_upright_body(joints_, classes_);
    if (!body || !body->has_arms)
      throw Error(target.name + ": human limits need a human body; expected two arms, two legs and a torso");
    body_ = *body;
    frame_ = body_frame(joints_, body_, up);
    for (size_t j = joints_.size(); j-- > 0;) find_next(static_cast<int>(j));
  }

  std::vector<sinew_joint_limit> run() {
    for (size_t j = 0; j < joints_.size(); ++j) {
      const int parent = joints_[j].parent;
      if (parent < 0 || classes_[j] >= SINEW_CLASS_OTHER) continue;
      const bool goes_on = classes_[static_cast<size_t>(parent)] == classes_[j];  // a twist, a second half of a bone
      add(static_cast<int>(j), goes_on);
    }
    return std::move(limits_);
  }

 private:
  Point3 at(int j) const { return point(joints_[static_cast<size_t>(j)].position); }
  uint8_t class_of(int j) const { return classes_[static_cast<size_t>(j)]; }

  // The bone's end: of the children the one of the limb, else the farthest.
  void find_next(int j) {
    const int parent = joints_[static_cast<size_t>(j)].parent;
    if (parent < 0) return;
    int& next = next_[static_cast<size_t>(parent)];
    const auto rank = [&](int child) {
      const bool limb = class_of(child) < SINEW_CLASS_OTHER;
      return (limb ? 1e6 : 0) + length(at(child) - at(parent));
    };
    if (next < 0 || rank(j) > rank(next)) next = j;
  }
  int end_of(int j) const {
    for (const auto& limbs : {body_.legs, body_.arms})
      for (const UprightLimb& limb : limbs) {
        if (limb.upper == j) return limb.middle;
        if (limb.middle == j) return limb.end;
      }
    return next_[static_cast<size_t>(j)];
  }
  Point3 bone(int j) const {
    const int end = end_of(j), parent = joints_[static_cast<size_t>(j)].parent;
    const Point3 own = end >= 0 ? at(end) - at(j) : Point3{};
    return unit(length(own) > 0 ? own : at(j) - at(parent));
  }

  void add(int j, bool goes_on) {
    switch (class_of(j)) {
      case SINEW_CLASS_SPINE:
        return ball(j, kSpine, bone(j), frame_.left);
      case SINEW_CLASS_NECK:
        return ball(j, kNeck, bone(j), frame_.left);
      case SINEW_CLASS_HEAD:
        if (!goes_on) ball(j, kHeadBall, frame_.up, frame_.left);
        return;
      case SINEW_CLASS_CLAVICLE:
        return ball(j, kClavicle, bone(j), frame_.up);
      case SINEW_CLASS_THIGH:
        if (!goes_on) thigh(j);
        return;
      case SINEW_CLASS_UPPER_ARM:
        if (!goes_on) upper_arm(j);
        return;
      case SINEW_CLASS_CALF:
      case SINEW_CLASS_FOREARM:
        if (!goes_on) bend(j);
        return;
      case SINEW_CLASS_HAND:
        if (!goes_on) ball(j, kHand, bone(j), frame_.up);
        return;
      case SINEW_CLASS_FOOT:
        if (!goes_on) ball(j, kFoot, -1.0 * frame_.up, frame_.left);
        return;
      default:
        return;
    }
  }

  double side_of(int j) const { return dot(at(j) - frame_.middle, frame_.left) < 0 ? -1 : 1; }

  // Makes the limits symmetric if the front is unknown.
  Ends either_way(const Ends& ends) const {
    if (length(frame_.front) > 0) return ends;
    const float most = std::max(-ends.least, ends.most);
    return {-most, most};
  }

  void thigh(int j) {
    Ball limit = kThigh;
    if (side_of(j) < 0) limit.second = {-limit.second.most, -limit.second.least};
    limit.first = either_way(limit.first);
    ball(j, limit, bone(j), frame_.left, -1.0 * frame_.up);
  }
  void upper_arm(int j) {
    Ball limit = kUpperArm;
    if (side_of(j) < 0) limit.first = {-limit.first.most, -limit.first.least};
    limit.first = either_way(limit.first);
    ball(j, limit, bone(j), frame_.up, side_of(j) * frame_.left);
  }
  // Knees and elbows.
  void bend(int j) {
    const bool calf = class_of(j) == SINEW_CLASS_CALF;
    int upper = joints_[static_cast<size_t>(j)].parent;
    const uint8_t above = calf ? SINEW_CLASS_THIGH : SINEW_CLASS_UPPER_ARM;
    while (upper >= 0 && class_of(upper) != above) upper = joints_[static_cast<size_t>(upper)].parent;
    if (upper < 0) return;
    const Point3 along = unit(at(j) - at(upper)), own = bone(j);
    Ball limit = calf ? kCalf : kForearm;
    std::optional<Point3> to = bend_side(along, own, frame_.front, calf);
    if (!to) {
      limit.first = {-limit.first.most, limit.first.most};
      limit.second = limit.first;
      to = across(std::abs(along[0]) < 0.9 ? Point3{1, 0, 0} : Point3{0, 1, 0}, along);
    }
    ball(j, limit, own, cross(along, unit(*to)), along);
  }

  //   bone, side  in the world at rest; `straight` is the bone's direction at angle 0, by default that of the rest pose
  void ball(int j, const Ball& ends, const Point3& bone, const Point3& side, const Point3& straight = {}) {
    const Quaternion zero = length(straight) > 0 ? rotation_between(bone, straight) : kNoRotation4;
    Point3 own = rotate(conjugate(zero), side);
    if (length(across(own, bone)) < 0.1)
      own = across(std::abs(bone[0]) < 0.9 ? Point3{1, 0, 0} : Point3{0, 1, 0}, bone);
    sinew_joint_limit limit = {};
    limit.joint = static_cast<uint32_t>(j);
    limit.kind = SINEW_LIMIT_BALL;
    for (size_t i = 0; i < 4; ++i) limit.zero[i] = static_cast<float>(zero[i]);
    for (size_t i = 0; i < 3; ++i) {
      limit.axis[i] = static_cast<float>(bone[i]);
      limit.side[i] = static_cast<float>(own[i]);
    }
    const Ends all[3] = {ends.twist, ends.first, ends.second};
    for (size_t i = 0; i < 3; ++i) {
      limit.least[i] = all[i].least;
      limit.most[i] = all[i].most;
    }
    if (length(bone) > 0) limits_.push_back(limit);
  }

  const std::vector<Joint>& joints_;
  const std::vector<uint8_t> classes_;
  std::vector<int> next_;  // [J] where its bone ends, -1 = nowhere
  UprightBody body_;
  BodyFrame frame_;
  std::vector<sinew_joint_limit> limits_;
};

}  // namespace

std::vector<sinew_joint_limit> human_joint_limits(const MapRig& target, MaybeAxis up) {
  return HumanLimits(target, up).run();
}

}  // namespace sinew
