// SPDX-License-Identifier: MIT
// A puppet's joints turned and its limbs bent to where they reach; a foot over one cycle of a gait.
#include "clips/puppet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::clips {

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }
Quaternion about_x(double degrees) { return axis_rotation(0, radians(degrees)); }
Quaternion about_y(double degrees) { return axis_rotation(1, radians(degrees)); }
Quaternion about_z(double degrees) { return axis_rotation(2, radians(degrees)); }
double wave(double turns) { return std::sin(2 * std::numbers::pi * turns); }

double curve(std::initializer_list<Key> keys, double phase) {
  const std::vector<Key> k(keys);
  const size_t count = k.size();
  size_t above = 0;
  while (above < count && k[above].phase <= phase) ++above;
  const auto key = [&](size_t i) {  // counted from the last key of the cycle before
    const size_t at = i % count;
    return Key{k[at].phase + std::floor(static_cast<double>(i) / static_cast<double>(count)), k[at].value};
  };
  const size_t first = above + count - 1;
  const double t = phase + 1;
  const auto slope = [&](size_t i) { return (key(i + 1).value - key(i).value) / (key(i + 1).phase - key(i).phase); };
  const auto tangent = [&](size_t i) {  // the harmonic mean; none at a peak
    const double a = slope(i - 1), b = slope(i);
    return a * b > 0 ? 2 * a * b / (a + b) : 0.0;
  };
  const Key from = key(first), to = key(first + 1);
  const double span = to.phase - from.phase, s = (t - from.phase) / span, s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * from.value + (s3 - 2 * s2 + s) * span * tangent(first) + (3 * s2 - 2 * s3) * to.value +
         (s3 - s2) * span * tangent(first + 1);
}

Puppet::Puppet(const std::string& skeleton, std::string prefix)
    : prefix_(std::move(prefix)), motion_(motion_of(skeleton_template(skeleton))), rest_(rest_joints(motion_)) {
  for (size_t j = 0; j < motion_.joints.size(); ++j) index_[motion_.joints[j].name] = j;
  to_rest();
}

void Puppet::to_rest() {
  frame_ = {};
  frame_.rotations.assign(motion_.joints.size(), kNoRotation4);
  for (const MotionJoint& joint : motion_.joints) frame_.translations.push_back(joint.offset);
}

void Puppet::place(const Point3& shift, const Quaternion& rotation) {
  frame_.translations[0] = motion_.joints[0].offset + shift;
  frame_.rotations[0] = rotation;
}

size_t Puppet::index(const std::string& joint) const {
  const auto found = index_.find(prefix_ + joint);
  if (found == index_.end()) throw Error("clips: expected a joint of the skeleton, found " + joint);
  return found->second;
}

Quaternion Puppet::world_rotation(int joint) const {
  Quaternion q = kNoRotation4;
  for (; joint >= 0; joint = motion_.joints[static_cast<size_t>(joint)].parent)
    q = multiply(frame_.rotations[static_cast<size_t>(joint)], q);
  return normalised(q);
}

Point3 Puppet::world_position(size_t joint) const {
  Point3 p = frame_.translations[joint];
  for (int j = motion_.joints[joint].parent; j >= 0; j = motion_.joints[static_cast<size_t>(j)].parent)
    p = frame_.translations[static_cast<size_t>(j)] + rotate(frame_.rotations[static_cast<size_t>(j)], p);
  return p;
}

Point3 Puppet::position(const std::string& joint) const { return world_position(index(joint)); }
Point3 Puppet::rest_position(const std::string& joint) const { return point(rest_[index(joint)].position); }

void Puppet::turn(const std::string& joint, const Quaternion& against_parent) {
  frame_.rotations[index(joint)] = normalised(against_parent);
}

void Puppet::turn_in_world(const std::string& joint, const Quaternion& rotation) {
  const size_t j = index(joint);
  frame_.rotations[j] = normalised(multiply(conjugate(world_rotation(motion_.joints[j].parent)), rotation));
}

void Puppet::reach(const Limb& limb, const Point3& target, const Point3& bend) {
  const Point3 hip = position(limb.upper);
  const Point3 upper = rest_position(limb.lower) - rest_position(limb.upper);
  const Point3 lower = rest_position(limb.end) - rest_position(limb.lower);
  const double a = length(upper), b = length(lower), wanted = length(target - hip);
  stretch_ = std::max(stretch_, wanted / (a + b));
  const double reach = std::clamp(wanted, 1.001 * std::abs(a - b), 0.9999 * (a + b));
  const Point3 along = unit(target - hip), out = unit(across(bend, along));
  const double before = (a * a + reach * reach - b * b) / (2 * reach);
  const double aside = std::sqrt(std::max(0.0, a * a - before * before));
  const Point3 middle = hip + before * along + aside * out, end = hip + reach * along;
  // Across the plane in which it bends: no bone ever lies along that.
  const Point3 hinge = cross(upper, limb.bend), turned = cross(along, out);
  turn_in_world(limb.upper, rotation_between(upper, hinge, middle - hip, turned));
  turn_in_world(limb.lower, rotation_between(lower, hinge, end - middle, turned));
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
