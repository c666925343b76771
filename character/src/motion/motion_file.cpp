// SPDX-License-Identifier: MIT
// A motion from a file or of the clips that ship, its frames over the floor of its rest pose.
#include "sinew_character/motion/motion_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "motion/upright_body.hpp"
#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/median.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Up at rest and in the frames, and the floor that decides which of the two is meant.

namespace {

constexpr double kStands = 0.85, kLies = 0.5;             // cosine of what a torso leans, in the median frame
constexpr double kBelowFloor = 0.05, kAboveFloor = 0.15;  // of the body's height: where its lowest joint may be

// A trunk's direction and the joints of one pose.
struct TrunkPose {
  Point3 trunk;
  std::vector<Point3> positions;
};

Point3 trunk_of(const UprightBody& body, const std::vector<Point3>& at) {
  const auto p = [&](int joint) { return at[static_cast<size_t>(joint)]; };
  const int top = body.head >= 0 ? body.head : body.chest;
  return unit(p(top) - 0.5 * (p(body.legs[0].upper) + p(body.legs[1].upper)));
}

double lowest(const std::vector<Point3>& positions, size_t axis) {
  double low = positions.front()[axis];
  for (const Point3& p : positions) low = std::min(low, p[axis]);
  return low;
}

double median_along(const std::vector<TrunkPose>& frames, size_t axis) {
  std::vector<double> values;
  for (const TrunkPose& frame : frames) values.push_back(frame.trunk[axis]);
  return median(&values);
}

bool on_floor(const std::vector<TrunkPose>& frames, size_t axis, double height) {
  std::vector<double> values;
  for (const TrunkPose& frame : frames) values.push_back(lowest(frame.positions, axis));
  const double low = median(&values);
  return low > -kBelowFloor * height && low < kAboveFloor * height;
}

size_t largest(const Point3& p) {
  size_t best = 0;
  for (size_t k = 1; k < 3; ++k) best = std::abs(p[k]) > std::abs(p[best]) ? k : best;
  return best;
}

}  // namespace

std::optional<Motion> motion_on_rest_floor(const Motion& motion) {
  const MapRig rig = map_rig_of(motion);
  const std::optional<UprightBody> body = find_upright_body(rig.joints, limb_classes(rig, {}));
  std::vector<Point3> rest;
  for (const Joint& joint : rig.joints)
    rest.push_back({double{joint.position.x}, double{joint.position.y}, double{joint.position.z}});
  if (!body || !is_upright(*body, rest)) return std::nullopt;
  const size_t up = largest(trunk_of(*body, rest));
  double high = rest[0][up];
  for (const Point3& p : rest) high = std::max(high, p[up]);
  const double height = high - lowest(rest, up);

  std::vector<TrunkPose> frames;
  for (const Clip& clip : motion.clips)
    for (const MotionFrame& frame : clip.frames) {
      std::vector<Point3> positions = world_pose(motion, frame).positions;
      const Point3 trunk = trunk_of(*body, positions);
      frames.push_back({trunk, std::move(positions)});
    }
  if (frames.empty() || std::abs(median_along(frames, up)) > kLies || on_floor(frames, up, height)) return std::nullopt;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (axis == up || median_along(frames, axis) < kStands || !on_floor(frames, axis, height)) continue;
    Point3 from{}, to{};
    from[axis] = to[up] = 1;
    const Quaternion raise = rotation_between(from, to);
    Motion out = motion;
    for (Clip& clip : out.clips)
      for (MotionFrame& frame : clip.frames)
        for (size_t j = 0; j < out.joints.size(); ++j) {
          if (out.joints[j].parent >= 0) continue;
          frame.rotations[j] = normalized(multiply(raise, frame.rotations[j]));
          frame.translations[j] = rotate(raise, frame.translations[j]);
        }
    out.notes.push_back(std::string("its rest pose has ") + "xyz"[up] + " up and its frames have " + "xyz"[axis] +
                        " up; they were rotated upright, a guess");
    return out;
  }
  return std::nullopt;
}

namespace {

// Whether a motion would play, how near its kind of body is, how much of both bodies a map from the motion's reaches,
// how many joints of the rig it moves.
using Fit = std::tuple<bool, std::ptrdiff_t, float, size_t>;
Fit fit_of(const Motion& motion, const MapRig& rig, MaybeAxis up) {
  MapSkeletonOptions options;
  options.target_up = up;
  const MapRig from = map_rig_of(motion);
  const MappedSkeleton found = map_skeleton(rig, from, options);
  const MapCover cover =
      map_cover(rig, options.target_up, from, options.source_up, {found.sources.begin(), found.sources.end()});
  return {cover.share >= kLeastCover, -static_cast<std::ptrdiff_t>(cover.kinds_apart), cover.share, found.mapped};
}

bool has_all_joints_of(const Motion& whole, const Motion& part) {
  return std::all_of(part.joints.begin(), part.joints.end(), [&](const MotionJoint& joint) {
    return std::any_of(whole.joints.begin(), whole.joints.end(),
                       [&](const MotionJoint& other) { return other.name == joint.name; });
  });
}

// Among bodies that fit alike, the first one, or a simpler form of it: legs of two joints move as such.
Motion motion_of_request(const MotionRequest& request, const MapRig& rig) {
  if (!is_builtin_motion(request.path)) return read_motion(request.path, request.fps, request.layout);
  if (!request.layout.empty()) check_layout(request.path);
  std::vector<Motion> motions = builtin_motions(request.path);
  size_t best = 0;
  Fit best_fit;
  for (size_t m = 0; m < motions.size() && motions.size() > 1; ++m) {
    const Fit fit = fit_of(motions[m], rig, request.up);
    if (m > 0 && (fit < best_fit || (fit == best_fit && !has_all_joints_of(motions[best], motions[m])))) continue;
    best = m;
    best_fit = fit;
  }
  return std::move(motions[best]);
}

}  // namespace

MotionFile read_motion_for(const MotionRequest& request, const MapRig& rig) {
  Motion motion = motion_of_request(request, rig);
  std::optional<Motion> one = one_actor(motion, request.path, request.actor);
  MotionFile file = one ? MotionFile{std::move(*one), false} : MotionFile{std::move(motion), true};
  const MaybeAxis down = request.down || !request.find_down ? request.down : axis_that_points_down(file.motion);
  if (down) {
    file = {turned_over(std::move(file.motion), *down), false};
    if (!request.down)
      file.motion.notes.push_back(std::string("its body is upside down, so -") + "xyz"[axis_index(*down)] +
                                  " was taken as up");
  }
  if (std::optional<Motion> level = motion_on_rest_floor(file.motion)) file.motion = std::move(*level);
  return file;
}

}  // namespace sinew
