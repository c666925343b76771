// SPDX-License-Identifier: MIT
// What a joint is there for. Rigs bring joints along that no vertex should follow: controls and targets of inverse
// kinematics, slots for weapons, roots on the floor, the tips that end chains.
#ifndef SINEW_CHARACTER_JOINT_ROLES_HPP
#define SINEW_CHARACTER_JOINT_ROLES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

enum class JointRole : uint8_t {
  kDeforms,  // moves the mesh, as far as anyone can tell
  kRoot,     // carries the whole rig
  kControl,  // handle, pole or target that other joints follow
  kSlot,     // where weapons, hats and other things are attached
  kTip       // ends a chain, so that its last bone has a length: exporters write and drop such joints as they like
};
const char* joint_role_text(JointRole role);  // "root", "control", ...

// By name and place in the hierarchy alone. [J]. Names are read as words: HandIK.L is hand, ik, l. A name that most
// joints of a rig share says nothing about any of them, a control that stands in the middle of a limb is a limb, and
// only what ends a chain is a tip.
std::vector<JointRole> joint_roles(const std::vector<Joint>& joints);

// Joints that stand outside of the mesh and far from it, with everything below them: as kControl into `roles` [J].
void find_joints_beside_mesh(const Character& character, std::vector<JointRole>* roles);

}  // namespace sinew
#endif
