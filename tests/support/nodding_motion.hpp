// SPDX-License-Identifier: MIT
// A motion that bends every joint of a character but its roots, further from frame to frame.
#ifndef SINEW_TESTS_SUPPORT_NODDING_MOTION_HPP
#define SINEW_TESTS_SUPPORT_NODDING_MOTION_HPP

#include <string>

#include "sinew_formats/character.hpp"

namespace sinew {

// 31 frames of two joints, the second from 0 to 30 degrees about x.
inline std::string nodding_bvh() {
  std::string text =
      "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
      "JOINT b\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\n"
      "MOTION\nFrames: 31\nFrame Time: 0.1\n";
  for (int f = 0; f < 31; ++f) text += "0 0 0 0 0 0 0 " + std::to_string(f) + " 0\n";
  return text;
}

// Legs and arms of the character follow b: a joint map as `animate --map` reads it.
inline std::string nodding_map(const Character& character) {
  std::string text;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    const Joint& joint = character.joints[j];
    text += joint.name + (joint.parent < 0 ? " a\n" : j % 2 == 0 ? " b\n" : " -\n");
  }
  return text;
}

}  // namespace sinew
#endif
