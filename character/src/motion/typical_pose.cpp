// SPDX-License-Identifier: MIT
// Frames with the most frequent orientation of the torso, their mean relative to the torso, and its symmetrization.
#include "motion/typical_pose.hpp"

#include <algorithm>

namespace sinew {
namespace {

constexpr double kTall = 0.3;  // share of frames

// The sum of what lies between mirror images, all on one side.
Point3 normal_of(const MirrorPairs& pairs, const std::vector<Point3>& positions) {
  Point3 normal{};
  for (const auto& [a, b] : pairs) {
    const Point3 d = positions[static_cast<size_t>(a)] - positions[static_cast<size_t>(b)];
    normal = normal + (dot(d, normal) < 0 ? -1.0 : 1.0) * d;
  }
  return normal;
}

// The tallest of the frames with the most frequent orientation of the root.
std::vector<size_t> typical_frames(const MovingJoints& moving, int root, const Point3& up) {
  constexpr double kSame = 0.9;  // cosine
  std::vector<Point3> ups;
  for (size_t f = 0; f < moving.frame_count(); ++f) ups.push_back(rotate(conjugate(moving.rotation(f, root)), up));
  const auto same = [&](size_t f) {
    return std::count_if(ups.begin(), ups.end(), [&](const Point3& own) { return dot(own, ups[f]) > kSame; });
  };
  size_t most = 0;
  for (size_t f = 1; f < ups.size(); ++f) most = same(f) > same(most) ? f : most;
  const double share = kTall * static_cast<double>(same(most)) / static_cast<double>(ups.size());
  return moving.best_frames(share, [&](size_t f) {
    double low = 0, high = 0;
    for (size_t j = 0; j < moving.order().size(); ++j) {
      const double own = dot(moving.position(f, static_cast<int>(j)) - moving.position(f, root), up);
      low = std::min(low, own);
      high = std::max(high, own);
    }
    return dot(ups[f], ups[most]) > kSame ? high - low : 0;
  });
}

}  // namespace

double asymmetry(const MirrorPairs& pairs, const std::vector<Point3>& positions) {
  const auto at = [&](int joint) { return positions[static_cast<size_t>(joint)]; };
  const Point3 normal = unit(normal_of(pairs, positions));
  Point3 middle{};
  for (const auto& [a, b] : pairs) middle = middle + at(a) + at(b);
  middle = (0.5 / static_cast<double>(pairs.size())) * middle;
  double off = 0, size = 0, apart = 0;
  for (const auto& [a, b] : pairs) {
    const Point3 from = at(a) - middle;
    off += length(from - 2 * dot(from, normal) * normal - (at(b) - middle));
    size += length(from) + length(at(b) - middle);
    apart += length(at(a) - at(b));
  }
  return apart > 0.05 * size ? 2 * off / size : 1;
}

bool is_in_one_line(const std::vector<MotionJoint>& joints) {
  constexpr double kAlong = 0.9, kNearlyAll = 0.8;  // cosine; share of all lengths
  Point3 line{};
  double all = 0, along = 0;
  for (const MotionJoint& joint : joints) {
    if (joint.parent < 0 || joints[static_cast<size_t>(joint.parent)].parent < 0) continue;
    line = line + (dot(joint.offset, line) < 0 ? -1.0 : 1.0) * joint.offset;
    all += length(joint.offset);
  }
  line = unit(line);
  for (const MotionJoint& joint : joints) {
    if (joint.parent < 0 || joints[static_cast<size_t>(joint.parent)].parent < 0) continue;
    if (std::abs(dot(unit(joint.offset), line)) > kAlong) along += length(joint.offset);
  }
  return along > kNearlyAll * all;
}

std::vector<Quaternion> typical_pose(const MovingJoints& moving, const MirrorPairs& pairs, const Point3& up) {
  const int root = moving.trunk_root();
  const std::vector<size_t> frames = typical_frames(moving, root, up);
  const Quaternion raise = rotation_between(moving.mean_direction(frames, root, up), up);
  std::vector<Quaternion> pose;
  for (size_t j = 0; j < moving.order().size(); ++j)
    pose.push_back(multiply(raise, moving.mean_rotation(frames, root, static_cast<int>(j))));
  const std::vector<Point3> positions = moving.posed(pose);
  const Point3 normal = unit(across(normal_of(pairs, positions), up));
  for (const auto& [a, b] : pairs) {  // parents first
    const int up_a = moving.parent(a), up_b = moving.parent(b);
    const Point3 x = rotate(pose[static_cast<size_t>(up_a)], moving.offset(a));
    const Point3 y = rotate(pose[static_cast<size_t>(up_b)], moving.offset(b));
    if (up_a == up_b) continue;
    const Point3 mean = 0.5 * (x + y - 2 * dot(y, normal) * normal);
    const Point3 image = mean - 2 * dot(mean, normal) * normal;
    const Quaternion swing_a = rotation_between(x, mean), swing_b = rotation_between(y, image);
    pose[static_cast<size_t>(up_a)] = multiply(swing_a, pose[static_cast<size_t>(up_a)]);
    pose[static_cast<size_t>(up_b)] = multiply(swing_b, pose[static_cast<size_t>(up_b)]);
  }
  return pose;
}

}  // namespace sinew
