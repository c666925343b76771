// SPDX-License-Identifier: MIT
// Classifies joints of a file by names, positions and weights: sinew_joint_classes().
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
  std::vector<int8_t> sides;      // [J] 1 left, -1 right, 0 unknown
  std::vector<int32_t> numbers;   // [J] as in sinew_joint_verdicts; so are the members below
  std::vector<int32_t> partners;  // [J]
  std::vector<int32_t> images;    // [J]
  bool mirrored = false;
  uint32_t mirror_axis = 0;
  std::array<float, 3> mirror_planes{};

  bool is_end(size_t joint) const { return roles[joint] == SINEW_ROLE_END; }
  // Returns whether a joint is part of the body as in target and predicted skeletons: not a control, slot, finger,
  // face or half of a limb.
  bool is_part(size_t joint) const {
    return roles[joint] == SINEW_ROLE_DEFORMS || roles[joint] == SINEW_ROLE_ROOT || is_end(joint);
  }
};

//   follows  [J] sinew_follows, or empty
// Throws Error for joints that form a cycle, more than SINEW_MAX_JOINTS joints, and positions that are not finite.
JointVerdicts joint_verdicts(const std::vector<Joint>& joints, const std::vector<uint8_t>& follows = {});

// Returns [J] sinew_follows from the character's weights; empty without weights.
std::vector<uint8_t> follows_of(const Character& character);

// Returns whether a name is that of a bone end in rig.txt files: NAME_end, NAME_End2.
bool names_bone_end(std::string name);

const char* joint_role_text(uint32_t role);          // "deforms", "root", "control", ...
const char* joint_class_text(uint32_t joint_class);  // "pelvis", "upperarm", ...; kClassTip is "tip"

// Marks joints far outside the mesh, and their descendants, as controls in `roles` [J].
void find_joints_beside_mesh(const Character& character, std::vector<uint8_t>* roles);
// Marks leaves called tip or leaf that are far from the mesh as ends in `roles` [J].
void find_tips_without_mesh(const Character& character, std::vector<uint8_t>* roles);

// Returns in how many of the six axis directions a ray from `p` hits a face (as a fan of triangles).
int directions_with_mesh(const Character& character, const Vec3& p);
constexpr int kMostHitsOutside = 2;  // maximum number of hits for a point outside the mesh

}  // namespace sinew
#endif
