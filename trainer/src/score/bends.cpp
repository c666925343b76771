// SPDX-License-Identifier: MIT
// Bends of the report's pictures, the step before bend_pictures.cpp and garment_pictures.cpp.
#include "bends.hpp"

#include <cmath>

#include "sinew/rig.h"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

Vec3d position_of(const Joint& joint) {
  return {static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
          static_cast<double>(joint.position.z)};
}

Vec3d rotation_axis(const Character& character, size_t joint, const Bend& bend, Axis up) {
  const Vec3d at = position_of(character.joints[joint]);
  if (bend.twist) return unit(at - position_of(character.joints[static_cast<size_t>(character.joints[joint].parent)]));
  const Vec3d after = bone_direction(character, joint);
  const Vec3d front = up == Axis::kZ ? Vec3d{0, -1, 0} : Vec3d{0, 0, 1},
              upwards = up == Axis::kZ ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
  const Vec3d direction = bend.upwards ? upwards : bend.backwards ? -1.0 * front : front;
  const Vec3d axis = cross(after, direction);
  return unit(length(axis) > 0.3 ? axis : cross(after, front));  // an arm that hangs down
}

}  // namespace

const std::vector<Bend>& report_bends() {
  static const std::vector<Bend> bends = {
      {SINEW_CLASS_FOREARM, "elbow, bent by", 130, false, true, false, 20},
      {SINEW_CLASS_CALF, "knee, bent by", 130, false, false, true, 20},
      {SINEW_CLASS_THIGH, "hip, thigh forward by", 90, false, false, false, 45},
      {SINEW_CLASS_UPPER_ARM, "shoulder, arm turned by", 75, false, true, false, 20},
      {SINEW_CLASS_HAND, "wrist, twisted by", 150, true, false, false, 20}};
  return bends;
}

size_t bent_joint(const Character& character, const LabelledSkeleton& labels, const Bend& bend) {
  std::vector<double> weight(character.joints.size(), 0);
  std::vector<char> has_child(character.joints.size(), 0);
  for (const auto& row : character.influences)
    for (const Influence& influence : row) weight[influence.joint] += static_cast<double>(influence.weight);
  for (const Joint& joint : character.joints)
    if (joint.parent >= 0) has_child[static_cast<size_t>(joint.parent)] = 1;
  size_t best = SIZE_MAX;
  for (size_t j = 0; j < weight.size(); ++j) {
    if (labels.classes[j] != bend.joint_class || labels.ends[j] != 0 || character.joints[j].parent < 0 ||
        weight[j] <= 0 || (has_child[j] == 0 && !bend.twist))
      continue;
    if (best == SIZE_MAX || weight[j] > weight[best]) best = j;
  }
  return best;
}

Vec3d bone_direction(const Character& character, size_t joint) {
  const Vec3d at = position_of(character.joints[joint]);
  Vec3d sum{0, 0, 0};
  for (const Joint& child : character.joints)
    if (child.parent == static_cast<int>(joint)) sum = sum + (position_of(child) - at);
  return unit(sum);
}

std::string bend_text(const Bend& bend, double degrees) { return print("%s %.0f degrees", bend.what, degrees); }

BentView bent_view(const Character& character, size_t joint, const Bend& bend, double degrees, Axis up, float radius,
                   int side) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  BentView out;
  const Vec3d axis = rotation_axis(character, joint, bend, up), at = position_of(character.joints[joint]);
  const Affine turn = rotation_about(axis_rotation({axis.x, axis.y, axis.z}, degrees * kDegree), {at.x, at.y, at.z});
  out.palette.assign(character.joints.size(), kIdentity);
  for (const size_t j : parents_first(character)) {
    const int parent = character.joints[j].parent;
    if (parent >= 0) out.palette[j] = out.palette[static_cast<size_t>(parent)];
    if (j == joint) out.palette[j] = multiply(out.palette[j], turn);
  }
  const Box box = box_of(character.vertices);
  RenderOptions& view = out.view;
  view.width = view.height = side;
  view.up = up;
  view.draw_skeleton = false;
  view.focus = character.joints[joint].position;
  view.focus_radius = radius * box.longest_side();
  // Along the axis of a bend, across a twist. An axis has two ends to look from.
  const double outward = view.focus.x < (box.low.x + box.high.x) / 2 ? -1 : 1;
  const Vec3d look = bend.twist ? (up == Axis::kZ ? Vec3d{0, -1, 0} : Vec3d{0, 0, 1}) : axis;
  double across = look.x, ahead = up == Axis::kZ ? -look.y : look.z;
  const bool from_front = std::abs(ahead) > 0.7;
  if (from_front ? ahead < 0 : outward * across < 0) across = -across, ahead = -ahead;
  view.yaw_degrees =
      static_cast<float>(std::atan2(across, ahead) / kDegree + (from_front ? bend.aside : -bend.aside) * outward);
  return out;
}

}  // namespace sinew
