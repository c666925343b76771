// SPDX-License-Identifier: MIT
// Rotates a puppet's joints and bends its limbs to their targets; a foot over one cycle of a gait.
#include "clips/puppet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::clips {
namespace {

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

// Parents first. Children of a spliced joint become children of its parent.
std::vector<Joint> joints_of(const std::string& skeleton, const std::set<std::string>& without,
                             const std::set<std::string>& spliced) {
  std::vector<Joint> kept;
  std::vector<int> places;
  for (Joint joint : skeleton_template(skeleton)) {
    const int parent = joint.parent < 0 ? -1 : places[static_cast<size_t>(joint.parent)];
    const bool gone = without.count(joint.name) != 0 || (joint.parent >= 0 && parent < 0);
    const bool stays = !gone && spliced.count(joint.name) == 0;
    places.push_back(gone ? -1 : stays ? static_cast<int>(kept.size()) : parent);
    joint.parent = parent;
    if (stays) kept.push_back(std::move(joint));
  }
  return kept;
}

}  // namespace

Quaternion about_x(double degrees) { return axis_rotation(0, radians(degrees)); }
Quaternion about_y(double degrees) { return axis_rotation(1, radians(degrees)); }
Quaternion about_z(double degrees) { return axis_rotation(2, radians(degrees)); }

Puppet::Puppet(const std::string& skeleton, std::string prefix, const std::vector<std::string>& without,
               const std::vector<std::string>& spliced)
    : prefix_(std::move(prefix)) {
  const auto both_sides = [&](const std::vector<std::string>& names) {
    std::set<std::string> all;
    for (const std::string& name : names) all.insert({prefix_ + name, other_side_name(prefix_ + name)});
    return all;
  };
  motion_ = motion_of(joints_of(skeleton, both_sides(without), both_sides(spliced)));
  for (const Joint& joint : rest_joints(motion_)) rest_.push_back(point(joint.position));
  for (size_t j = 0; j < motion_.joints.size(); ++j) index_[motion_.joints[j].name] = j;
  for (const Joint& joint : skeleton_template(skeleton))
    if (index_.count(joint.name) == 0) left_out_.insert(joint.name);
  for (size_t j = 0; j < motion_.joints.size(); ++j) {
    const std::string& name = motion_.joints[j].name;
    twins_.push_back(index_.at(other_side_name(name)));
    rights_.push_back(side_of_name(name) == Side::kRight);
  }
  to_rest();
}

void Puppet::to_rest() {
  frame_ = {};
  frame_.rotations.assign(motion_.joints.size(), kNoRotation4);
  for (const MotionJoint& joint : motion_.joints) frame_.translations.push_back(joint.offset);
}

size_t Puppet::index(const std::string& joint) const {
  const auto found = index_.find(prefix_ + joint);
  if (found == index_.end()) throw Error("gaits: expected a joint of the skeleton, found " + joint);
  return found->second;
}

Quaternion Puppet::world_rotation(int joint) const {
  Quaternion q = kNoRotation4;
  for (; joint >= 0; joint = motion_.joints[static_cast<size_t>(joint)].parent)
    q = multiply(frame_.rotations[static_cast<size_t>(joint)], q);
  return normalized(q);
}

Point3 Puppet::world_position(size_t joint) const {
  Point3 p = frame_.translations[joint];
  for (int j = motion_.joints[joint].parent; j >= 0; j = motion_.joints[static_cast<size_t>(j)].parent)
    p = frame_.translations[static_cast<size_t>(j)] + rotate(frame_.rotations[static_cast<size_t>(j)], p);
  return p;
}

void Puppet::turn_in_world(size_t joint, const Quaternion& rotation) {
  turn(joint, multiply(conjugate(carried(joint)), rotation));
}

void Puppet::reach(size_t upper, size_t lower, size_t end, const Point3& target, const Point3& bend) {
  const Point3 hip = world_position(upper);
  const Point3 first = rest_[lower] - rest_[upper], second = rest_[end] - rest_[lower];
  const double a = length(first), b = length(second), wanted = length(target - hip);
  stretch_ = std::max(stretch_, wanted / (a + b));
  const double reach = std::clamp(wanted, 1.001 * std::abs(a - b), 0.9999 * (a + b));
  const Point3 along = unit(target - hip), out = unit(across(bend, along));
  const double before = (a * a + reach * reach - b * b) / (2 * reach);
  const double aside = std::sqrt(std::max(0.0, a * a - before * before));
  const Point3 middle = hip + before * along + aside * out, tip = hip + reach * along;
  // Across the plane in which it bends: no bone ever lies along that.
  const Point3 hinge = cross(first, bend), turned = cross(along, out);
  turn_in_world(upper, rotation_between(first, hinge, middle - hip, turned));
  turn_in_world(lower, rotation_between(second, hinge, tip - middle, turned));
}

double Puppet::take_stretch() {
  const double stretch = stretch_;
  stretch_ = 0;
  return stretch;
}

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
