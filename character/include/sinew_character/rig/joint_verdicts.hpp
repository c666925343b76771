// SPDX-License-Identifier: MIT
// What joints are by their names, positions and weights: sinew_joint_classes() for joints of a file.
#ifndef SINEW_CHARACTER_JOINT_VERDICTS_HPP
#define SINEW_CHARACTER_JOINT_VERDICTS_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew/names.h"
#include "sinew_formats/character.hpp"

namespace sinew {

struct JointVerdicts {
  std::vector<uint8_t> classes;   // [J] sinew_joint_class
  std::vector<uint8_t> roles;     // [J] sinew_joint_role
  std::vector<int8_t> sides;      // [J] 1 left, -1 right, 0 not said
  std::vector<int32_t> numbers;   // [J] as sinew_joint_verdicts has them, as are those below
  std::vector<int32_t> partners;  // [J]
  std::vector<int32_t> images;    // [J]
  bool mirrored = false;
  uint32_t mirror_axis = 0;
  std::array<float, 3> mirror_planes{};

  bool is_end(size_t joint) const { return roles[joint] == SINEW_ROLE_END; }
  // Part of the body as target and predicted skeletons have them: no control, no slot, no finger, face or half of a limb.
  bool is_part(size_t joint) const {
    return roles[joint] == SINEW_ROLE_DEFORMS || roles[joint] == SINEW_ROLE_ROOT || is_end(joint);
  }
};

//   follows  [J] sinew_follows, or empty
// Throws Error for joints that form a cycle, more of them than SINEW_MAX_JOINTS, and positions that are not finite.
JointVerdicts joint_verdicts(const std::vector<Joint>& joints, const std::vector<uint8_t>& follows = {});

// [J] sinew_follows by the character's weights; empty where it has none.
std::vector<uint8_t> follows_of(const Character& character);

// NAME_end, NAME_End2: how rig.txt files of skeletons mark the ends of bones.
bool names_bone_end(std::string name);

const char* joint_role_text(uint32_t role);          // "deforms", "root", "control", ...
const char* joint_class_text(uint32_t joint_class);  // "pelvis", "upperarm", ...; kClassTip is "tip"

// Joints that stand outside of the mesh and far from it, with everything below them: controls, into `roles` [J].
void find_joints_beside_mesh(const Character& character, std::vector<uint8_t>* roles);
// Leaves called tip or leaf that no mesh is near: ends, into `roles` [J].
void find_tips_without_mesh(const Character& character, std::vector<uint8_t>* roles);

// In how many of the six directions along the axes a ray from `p` meets a face (as a fan of triangles).
int directions_with_mesh(const Character& character, const Vec3& p);
constexpr int kMostHitsOutside = 2;  // directions in which a point outside may see the mesh

}  // namespace sinew
#endif
