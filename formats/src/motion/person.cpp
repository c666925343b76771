// SPDX-License-Identifier: MIT
#include "motion/person.hpp"

#include <cmath>
#include <map>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

struct Row {
  const char *name, *parent;
  Point3 position;
  bool end = false;
};

// The left side alone.
constexpr Row kRows[] = {{"hips", "", {0, 0.95, 0}},
                         {"spine", "hips", {0, 1.05, -0.01}},
                         {"chest", "spine", {0, 1.16, -0.015}},
                         {"upperChest", "chest", {0, 1.27, -0.02}},
                         {"neck", "upperChest", {0, 1.44, -0.015}},
                         {"head", "neck", {0, 1.53, 0.01}},
                         {"jaw", "head", {0, 1.55, 0.03}},
                         {"nose_end", "head", {0, 1.53, 0.12}, true},
                         {"headTop_end", "head", {0, 1.7, 0.02}, true},
                         {"leftEye", "head", {0.03, 1.61, 0.09}},
                         {"leftEar_end", "head", {0.08, 1.53, 0.01}, true},
                         {"leftShoulder", "upperChest", {0.04, 1.39, -0.02}},
                         {"leftUpperArm", "leftShoulder", {0.17, 1.38, -0.03}},
                         {"leftLowerArm", "leftUpperArm", {0.44, 1.38, -0.035}},
                         {"leftHand", "leftLowerArm", {0.69, 1.38, -0.03}},
                         {"leftHand_end", "leftHand", {0.78, 1.38, -0.03}, true},
                         {"leftThumbMetacarpal", "leftHand", {0.715, 1.365, 0.005}},
                         {"leftThumbProximal", "leftThumbMetacarpal", {0.745, 1.355, 0.03}},
                         {"leftThumbDistal", "leftThumbProximal", {0.77, 1.35, 0.05}},
                         {"leftIndexProximal", "leftHand", {0.78, 1.38, 0.005}},
                         {"leftIndexIntermediate", "leftIndexProximal", {0.82, 1.38, 0.01}},
                         {"leftIndexDistal", "leftIndexIntermediate", {0.845, 1.38, 0.012}},
                         {"leftMiddleProximal", "leftHand", {0.785, 1.382, -0.02}},
                         {"leftMiddleIntermediate", "leftMiddleProximal", {0.828, 1.382, -0.02}},
                         {"leftMiddleDistal", "leftMiddleIntermediate", {0.857, 1.382, -0.02}},
                         {"leftRingProximal", "leftHand", {0.78, 1.38, -0.043}},
                         {"leftRingIntermediate", "leftRingProximal", {0.82, 1.38, -0.045}},
                         {"leftRingDistal", "leftRingIntermediate", {0.846, 1.38, -0.046}},
                         {"leftLittleProximal", "leftHand", {0.77, 1.375, -0.064}},
                         {"leftLittleIntermediate", "leftLittleProximal", {0.802, 1.375, -0.068}},
                         {"leftLittleDistal", "leftLittleIntermediate", {0.823, 1.375, -0.07}},
                         {"leftUpperLeg", "hips", {0.095, 0.9, 0}},
                         {"leftLowerLeg", "leftUpperLeg", {0.1, 0.49, 0.01}},
                         {"leftFoot", "leftLowerLeg", {0.105, 0.085, -0.03}},
                         {"leftToes", "leftFoot", {0.11, 0.02, 0.1}}};

const std::map<std::string, Row>& rows() {
  static const std::map<std::string, Row> by_name = [] {
    std::map<std::string, Row> all;
    for (const Row& row : kRows) {
      all.emplace(row.name, row);
      const std::string other = other_side_of_person(row.name);
      if (other == row.name) continue;
      Row mirrored = row;  // names of both sides are found by the map's keys
      mirrored.position[0] = -mirrored.position[0];
      all.emplace(other, mirrored);
    }
    return all;
  }();
  return by_name;
}

// The axis that is nearest, and its sign.
std::pair<size_t, double> nearest_axis(const Point3& direction) {
  size_t axis = 1;
  for (size_t i = 0; i < 3; ++i)
    if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
  return {axis, direction[axis] < 0 ? -1.0 : 1.0};
}

}  // namespace

std::string other_side_of_person(const std::string& name) {
  if (name.rfind("left", 0) == 0) return "right" + name.substr(4);
  if (name.rfind("right", 0) == 0) return "left" + name.substr(5);
  return name;
}

int joint_named(const std::vector<MotionJoint>& joints, const std::string& name) {
  for (size_t j = 0; j < joints.size(); ++j)
    if (joints[j].name == name) return static_cast<int>(j);
  return -1;
}

std::vector<MotionJoint> person_joints(const std::vector<std::string>& names) {
  std::vector<MotionJoint> joints;
  for (const std::string& name : names) joints.push_back({name, -1, {}, rows().at(name).end});
  for (size_t j = 0; j < names.size(); ++j) {
    Point3 from{};
    const bool right = names[j].rfind("right", 0) == 0;
    for (std::string above = names[j];;) {
      const std::string parent = rows().at(above).parent;
      above = right ? other_side_of_person(parent) : parent;
      if (above.empty()) break;
      joints[j].parent = joint_named(joints, above);
      if (joints[j].parent < 0) continue;
      from = rows().at(above).position;
      break;
    }
    joints[j].offset = rows().at(names[j]).position - from;
  }
  return joints;
}

double lowest_at_rest(const Motion& motion) {
  double low = 0;
  for (const Joint& joint : rest_joints(motion)) low = std::min(low, double{joint.position.y});
  return low;
}

Quaternion turn_to_y_up(const Point3& up) {
  const auto [axis, sign] = nearest_axis(up);
  Point3 from{};
  from[axis] = sign;
  return axis == 1 && sign < 0 ? axis_rotation(0, 2 * std::acos(0.0)) : rotation_between(from, {0, 1, 0});
}

std::string axis_name(const Point3& direction) {
  const auto [axis, sign] = nearest_axis(direction);
  return std::string(sign < 0 ? "-" : "") + "xyz"[axis];
}

}  // namespace sinew
