// SPDX-License-Identifier: MIT
#include "clips/gait.hpp"

#include <algorithm>
#include <cmath>

namespace sinew::clips {
namespace {

// Rolled by `pitch` about the point that is on the floor then.
Point3 rolled_ankle(const FootShape& shape, double pitch) {
  const Point3 pivot = pitch < 0 ? shape.heel : shape.ball;
  return pivot + rotate(about_x(pitch), shape.ankle - pivot);
}

Point3 standing_ankle(const FootPath& path, const FootShape& shape, double phase) {
  Point3 ankle = rolled_ankle(shape, path.pitch(phase));
  ankle[2] += path.front - path.stride * phase;
  return ankle;
}

}  // namespace

FootPose foot_at(const FootPath& path, const FootShape& shape, double phase) {
  FootPose pose;
  pose.pitch = path.pitch(phase);
  if (phase <= path.stance) {
    pose.ankle = standing_ankle(path, shape, phase);
    pose.toes = std::min(pose.pitch, 0.0);
    return pose;
  }
  constexpr double kStep = 1e-4;
  const double span = 1 - path.stance, s = (phase - path.stance) / span, s2 = s * s, s3 = s2 * s;
  const Point3 from = standing_ankle(path, shape, path.stance), to = standing_ankle(path, shape, 0);
  const Point3 leaving = (span / kStep) * (from - standing_ankle(path, shape, path.stance - kStep));
  const Point3 landing = (span / kStep) * (standing_ankle(path, shape, kStep) - to);
  pose.ankle =
      (2 * s3 - 3 * s2 + 1) * from + (s3 - 2 * s2 + s) * leaving + (3 * s2 - 2 * s3) * to + (s3 - s2) * landing;
  pose.ankle[1] += path.lift * 16 * s2 * (1 - s) * (1 - s);
  const Quaternion rolled = about_x(pose.pitch);
  for (const Point3& point : {shape.heel, shape.ball}) {  // neither is carried through the floor
    const double height = pose.ankle[1] + rotate(rolled, point - shape.ankle)[1];
    pose.ankle[1] += std::max(0.0, point[1] - height);
  }
  pose.toes = pose.pitch * std::min(1.0, 2 * s);
  return pose;
}

}  // namespace sinew::clips
