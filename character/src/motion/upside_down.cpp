// SPDX-License-Identifier: MIT
// Worlds whose axis points down, as those of cameras do: 180 degrees about another axis.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/upright_body.hpp"
#include "sinew_character/motion/motion_file.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/median.hpp"

namespace sinew {
namespace {

constexpr double kRest = 0.4,
                 kFrames = 0.6;  // cosine between trunk or legs and the axis; many rest poses are no stances

// The torso's direction in a pose, and that of the legs from the feet.
struct Stance {
  Point3 trunk, legs;
};
Stance stance_of(const UprightBody& body, const std::vector<Point3>& at) {
  const auto p = [&](int joint) { return at[static_cast<size_t>(joint)]; };
  const Point3 hips = 0.5 * (p(body.legs[0].upper) + p(body.legs[1].upper));
  return {unit(p(body.head >= 0 ? body.head : body.chest) - hips),
          unit(hips - 0.5 * (p(body.legs[0].end) + p(body.legs[1].end)))};
}

Quaternion half_turn(Axis down) { return axis_rotation((axis_index(down) + 1) % 3, std::numbers::pi); }

}  // namespace

Motion turned_over(Motion motion, Axis down) {
  const Quaternion turn = half_turn(down);
  for (MotionJoint& joint : motion.joints) joint.offset = rotate(turn, joint.offset);
  for (Clip& clip : motion.clips)
    for (MotionFrame& frame : clip.frames) {
      for (Quaternion& q : frame.rotations) q = normalized(multiply(multiply(turn, q), conjugate(turn)));
      for (Point3& t : frame.translations) t = rotate(turn, t);
    }
  return motion;
}

void turn_over(Axis down, std::vector<Joint>* joints) {
  const Quaternion turn = half_turn(down);
  for (Joint& joint : *joints) {
    const Point3 p = rotate(turn, point(joint.position));
    joint.position = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  }
}

MaybeAxis axis_that_points_down(const Motion& motion) {
  const MapRig rig = map_rig_of(motion);
  const std::optional<UprightBody> body = find_upright_body(rig.joints, limb_classes(rig, {}));
  if (!body) return std::nullopt;
  std::vector<Point3> rest;
  for (const Joint& joint : rig.joints) rest.push_back(point(joint.position));
  const Stance at_rest = stance_of(*body, rest);
  std::vector<size_t> candidates;
  for (size_t axis = 0; axis < 3; ++axis)
    if (at_rest.trunk[axis] <= -kRest && at_rest.legs[axis] <= -kRest) candidates.push_back(axis);
  if (candidates.empty()) return std::nullopt;  // as nearly always: no frame need be posed
  std::vector<Stance> frames;
  for (const Clip& clip : motion.clips)
    for (const MotionFrame& frame : clip.frames)
      frames.push_back(stance_of(*body, world_pose(motion, frame).positions));
  if (frames.empty()) return std::nullopt;
  for (const size_t axis : candidates) {
    std::vector<double> trunks, legs;
    for (const Stance& frame : frames) {
      trunks.push_back(frame.trunk[axis]);
      legs.push_back(frame.legs[axis]);
    }
    if (median(&trunks) < -kFrames && median(&legs) < -kFrames) return static_cast<Axis>(axis);
  }
  return std::nullopt;
}

}  // namespace sinew
