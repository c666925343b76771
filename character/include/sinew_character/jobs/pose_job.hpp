// SPDX-License-Identifier: MIT
// What `sinew pose` does with one bound character: a pose from a moment of a clip, and the mesh in it.
#ifndef SINEW_CHARACTER_POSE_JOB_HPP
#define SINEW_CHARACTER_POSE_JOB_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew/deform.h"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// A moment of one of the file's own animations.  `what`, or null: says which, for the user. Throws Error for a time behind the end.
std::vector<Affine> clip_palette(const Motion& motion, const std::string& file, const std::string& clip, double time,
                                 size_t joint_count, std::string* what);

struct PosedCharacter {
  Character character;
  bool corrected =
      true;  // false: the matrices are no rotations with one common scale, so the pose is plain linear skinning
};

//   correction  how bends are corrected; nullopt: plain skinning, linear or by dual quaternions
PosedCharacter pose_character(const Character& character, const std::vector<Affine>& palette,
                              const std::optional<sinew_deform_options>& correction, bool dual_quaternion);

}  // namespace sinew
#endif
