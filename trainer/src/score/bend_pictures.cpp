// SPDX-License-Identifier: MIT
// One joint turned, seen from the side on which it bends, by linear skinning and by the engine's deformer.
#include "sinew_trainer/bend_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec3d.hpp"
#include "sinew/deform.h"
#include "sinew/rig.h"
#include "sinew_datasets/image.hpp"
#include "sinew_datasets/label_skeleton.hpp"
#include "sinew_formats/box.hpp"
#include "sinew_formats/deform.hpp"
#include "sinew_formats/pose.hpp"

namespace sinew {
namespace {

// What is shown of a class of joints.
struct Bend {
  uint32_t joint_class;
  const char* what;
  double degrees;
  bool twist;      // about the bone before it
  bool upwards;    // as arms are raised, in the plane that the front view shows; else to the front
  bool backwards;  // as knees bend
};
constexpr Bend kBends[] = {{SINEW_CLASS_FOREARM, "elbow, bent by 130 degrees", 130, false, true, false},
                           {SINEW_CLASS_CALF, "knee, bent by 130 degrees", 130, false, false, true},
                           {SINEW_CLASS_THIGH, "hip, thigh forward by 90 degrees", 90, false, false, false},
                           {SINEW_CLASS_UPPER_ARM, "shoulder, arm turned by 75 degrees", 75, false, true, false},
                           {SINEW_CLASS_HAND, "wrist, twisted by 150 degrees", 150, true, false, false}};

Vec3d place(const Joint& joint) {
  return {static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
          static_cast<double>(joint.position.z)};
}

// The joint of a bend's class that has most vertices and, unless it is twisted, a bone of its own.
size_t find_joint(const Character& character, const LabelledSkeleton& labels, const Bend& bend) {
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

Vec3d turn_axis(const Character& character, size_t joint, const Bend& bend, bool up_z) {
  const Vec3d at = place(character.joints[joint]);
  const Vec3d before = unit(at - place(character.joints[static_cast<size_t>(character.joints[joint].parent)]));
  if (bend.twist) return before;
  Vec3d after{0, 0, 0};
  for (const Joint& child : character.joints)
    if (child.parent == static_cast<int>(joint)) after = after + (place(child) - at);
  const Vec3d front = up_z ? Vec3d{0, -1, 0} : Vec3d{0, 0, 1}, up = up_z ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
  const Vec3d way = bend.upwards ? up : bend.backwards ? -1.0 * front : front;
  const Vec3d axis = cross(unit(after), way);
  return unit(length(axis) > 0.3 ? axis : cross(unit(after), front));  // an arm that hangs down
}

}  // namespace

ReportPicture bend_pictures(const Character& character, bool up_z, int side) {
  constexpr float kRadius = 0.16f;  // of the longest side: what a picture shows
  ReportPicture picture;
  picture.heading = "bends";
  picture.character = character.name;
  picture.note = "left linear skinning, right with the volume kept (sinew pose --deform volume)";
  const LabelledSkeleton labels = label_skeleton(character.joints);
  CharacterDeformer deformer(character, sinew_deform_options_init());
  const std::vector<std::array<uint8_t, 3>> grey(character.vertices.size(), {200, 190, 180});
  RenderOptions view;
  view.width = view.height = side;
  view.up_z = up_z;
  view.draw_skeleton = false;
  view.focus_radius = kRadius * box_of(character.vertices).longest_side();
  for (const Bend& bend : kBends) {
    const size_t joint = find_joint(character, labels, bend);
    if (joint == SIZE_MAX) continue;
    const Vec3d axis = turn_axis(character, joint, bend, up_z), at = place(character.joints[joint]);
    const Affine turn = rotation_about(axis_rotation({axis.x, axis.y, axis.z}, bend.degrees * (std::acos(-1.0) / 180)),
                                       {at.x, at.y, at.z});
    std::vector<Affine> palette(character.joints.size(), kIdentity);
    for (const size_t j : parents_first(character)) {
      const int parent = character.joints[j].parent;
      if (parent >= 0) palette[j] = palette[static_cast<size_t>(parent)];
      if (j == joint) palette[j] = multiply(palette[j], turn);
    }
    view.focus = character.joints[joint].position;
    // Along the axis of a bend, across a twist.
    const Vec3d look = bend.twist ? (up_z ? Vec3d{0, -1, 0} : Vec3d{0, 0, 1}) : axis;
    const double across = look.x, ahead = up_z ? -look.y : look.z;
    view.yaw_degrees = static_cast<float>(std::atan2(across, ahead) * 180 / std::acos(-1.0)) + 20.0f;
    const Character linear = apply_pose(character, palette), kept = deformer.pose_character(character, palette);
    picture.panels.push_back({bend.what, encode_png(beside({render(linear, grey, view), render(kept, grey, view)}))});
  }
  return picture;
}

}  // namespace sinew
