// SPDX-License-Identifier: MIT
// Describes a motion's rest pose: whether it is a standing pose, the up axis, the arms.
#include "sinew_character/motion/motion_summary.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "motion/upright_body.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/stance.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr double kArmsOut = -0.26, kArmsDown = -0.9;  // cosines of upper arms against up: 105 and 154 degrees

// The axis that a direction is nearest to.
Axis axis_of(const Point3& direction) {
  size_t best = 0;
  for (size_t k = 1; k < 3; ++k) best = std::abs(direction[k]) > std::abs(direction[best]) ? k : best;
  return static_cast<Axis>(best);
}

std::string pose_of_arms(const UprightBody& body, const std::vector<Point3>& at, const Point3& up) {
  if (!body.has_arms) return "stands, without arms";
  double along = 0;
  for (const UprightLimb& arm : body.arms)
    along += 0.5 * dot(unit(at[static_cast<size_t>(arm.middle)] - at[static_cast<size_t>(arm.upper)]), up);
  if (along > -kArmsOut) return "stands, arms raised";
  if (along > kArmsOut) return "stands, arms out to the sides (T pose)";
  return along > kArmsDown ? "stands, arms lowered to the sides (A pose)" : "stands, arms down";
}

}  // namespace

RestSummary rest_summary(const Motion& motion) {
  const MapRig rig = map_rig_of(motion);
  const std::optional<UprightBody> body = find_upright_body(rig.joints, limb_classes(rig, {}));
  if (!body) return {std::nullopt, "found no body with two legs"};
  std::vector<Point3> rest;
  for (const Joint& joint : rig.joints) rest.push_back(point(joint.position));
  if (!is_upright(*body, rest))
    return {std::nullopt, standing_motion(motion) ? "not standing; a standing pose is taken from the frames"
                                                  : "not standing, nor in the frames"};
  const Point3 up = body_frame(rig.joints, *body, {}).up;
  return {axis_of(up), pose_of_arms(*body, rest, up)};
}

}  // namespace sinew
