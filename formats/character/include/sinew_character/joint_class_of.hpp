// SPDX-License-Identifier: MIT
// The class of a joint (engine/src/rig/joint_class.hpp) by its name: what makes skeletons of all makers comparable.
#ifndef SINEW_CHARACTER_JOINT_CLASS_OF_HPP
#define SINEW_CHARACTER_JOINT_CLASS_OF_HPP

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rig/joint_class.hpp"

namespace sinew {

// nullopt: a detail, such as a finger, a part of the face or a twist bone, which belongs to its parent.
//   below   names of the bound joints below it (joints that have weight), in any order: the front leg of a quadruped is
//           a clavicle where an upper leg follows, and a sided "leg" with joints below it is a lower leg
// Reads the names of Mixamo, Unreal, Rigify, MakeHuman, Quaternius, Kenney and their like; kClassOther for what says
// nothing. Letters beyond ASCII are letters like others.
std::optional<JointClass> joint_class_of(const std::string& name, const std::vector<std::string_view>& below);

// What the class is read from: lower case, without maker's prefix, side, digits and separators. Empty for a name of
// these alone.
std::string plain_joint_name(const std::string& name);

// What a leaf joint of a file is by its name: NAME_end or NAME_tip, digits behind it, is a bone end.
bool names_bone_end(std::string name);

const char* joint_class_text(uint32_t joint_class);  // "pelvis", "upperarm", ...; kClassTip is "tip"

}  // namespace sinew
#endif
