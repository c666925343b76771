// SPDX-License-Identifier: MIT
// Which joints an animator's controls move: IK of legs and arms, foot roll, spine, head, fingers that curl (formats/spec/controls.md). Programs
// make controls of it with what they have; the Blender add-on does.
#ifndef SINEW_CHARACTER_CONTROLS_HPP
#define SINEW_CHARACTER_CONTROLS_HPP

#include <array>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

using ControlDirection = std::array<double, 3>;  // unit vector in the world at rest; zero: nobody knows

// A leg or an arm that a hand or a foot pulls.
struct ControlLimb {
  std::string name;         // "leg.left", "arm.right.2"
  bool leg = false;         // else an arm
  int side = 0;             // 1 left, -1 right, 0: names do not tell
  std::vector<int> joints;  // each the next one's parent, from hip or shoulder to foot or hand
  int middle = -1;          // of them the knee or elbow
  int ball = -1;            // of a foot that rolls: the joint that its toes turn about; -1: none
  ControlDirection pole{};  // where knee or elbow points
};

struct ControlFinger {
  std::string name;         // "index.left"
  int side = 0;             // as above
  int hand = -1;            // the joint that it hangs on, perhaps behind a bone of the palm; -1: no hand
  std::vector<int> joints;  // from the hand outwards
  ControlDirection axis{};  // turned about it by the right hand's rule, the finger goes towards the palm
};

// Indices are those of the character's joints, -1: none.
struct ControlRig {
  ControlDirection up{}, front{};
  int hips = -1, head = -1;
  std::vector<int> spine, neck;  // from below
  std::vector<ControlLimb> limbs;
  std::vector<ControlFinger> fingers;
  std::vector<std::string> notes;  // what is not there, a line each
};

// By classes of joints, as limits and profiles have them; knees and elbows point away from where they bend. A character without legs, arms or a
// trunk has fewer controls, which the notes say. Throws Error for joints that joint_verdicts() refuses.
ControlRig find_controls(const Character& character);

// The file's text, with a line break at its end.
//   joints  [J] as they are written: their names and positions
//   turn    brings the rig's directions there
std::string controls_text(const ControlRig& rig, const std::string& name, const std::vector<Joint>& joints,
                          const Rotation& turn = kNoRotation);
std::string controls_text(const Character& character);

// The same as GlbOptions::extras: {"sinew_controls": ...}.
std::string controls_extras(const std::string& text);

}  // namespace sinew
#endif
