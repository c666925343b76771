// SPDX-License-Identifier: MIT
// Joints for an animator's controls: IK of legs and arms, foot roll, spine, head, finger curl
// (formats/spec/controls.md). Programs build controls from this list, as the Blender add-on does.
#ifndef SINEW_CHARACTER_CONTROLS_HPP
#define SINEW_CHARACTER_CONTROLS_HPP

#include <array>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

using ControlDirection = std::array<double, 3>;  // unit vector in the world at rest; zero: unknown

// An IK chain: a leg or an arm.
struct ControlLimb {
  std::string name;         // "leg.left", "arm.right.2"
  bool leg = false;         // false: arm
  int side = 0;             // 1 left, -1 right, 0: unknown
  std::vector<int> joints;  // each the parent of the next, from hip or shoulder to foot or hand
  int middle = -1;          // the knee or elbow of these
  int ball = -1;            // foot roll: the joint that the toes rotate about; -1: none
  ControlDirection pole{};  // direction of the knee or elbow
};

struct ControlFinger {
  std::string name;         // "index.left"
  int side = 0;             // as above
  int hand = -1;            // the ancestor hand joint, possibly with a palm bone in between; -1: no hand
  std::vector<int> joints;  // from the hand outwards
  ControlDirection axis{};  // curl axis: rotation about it by the right-hand rule moves the finger towards the palm
};

// Indices are those of the character's joints, -1: none.
struct ControlRig {
  ControlDirection up{}, front{};
  int hips = -1, head = -1;
  std::vector<int> spine, neck;  // from below
  std::vector<ControlLimb> limbs;
  std::vector<ControlFinger> fingers;
  std::vector<std::string> notes;  // missing controls, one line each
};

// Finds controls by classes of joints, as limits and profiles do; knees and elbows point away from their bend. A
// character without legs, arms or a torso has fewer controls, with a note. Throws Error for joints that joint_verdicts()
// rejects.
ControlRig find_controls(const Character& character);

// Returns the text of the file, with a final line break.
//   joints  [J] as written: names and positions
//   turn    rotation of the rig's directions to those of the written joints
std::string controls_text(const ControlRig& rig, const std::string& name, const std::vector<Joint>& joints,
                          const Rotation& turn = kNoRotation);
std::string controls_text(const Character& character);

// Returns GlbOptions::extras: {"sinew_controls": ...}.
std::string controls_extras(const std::string& text);

}  // namespace sinew
#endif
