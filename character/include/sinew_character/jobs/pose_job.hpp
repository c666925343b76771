// SPDX-License-Identifier: MIT
// The job of `sinew pose` for one bound character: a pose from a time in a clip, and the posed mesh.
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

// Returns the pose at a time in one of the file's animations. `what` (or null) gets a description for the user.
// Throws Error for a time after the end.
std::vector<Affine> clip_palette(const Motion& motion, const std::string& file, const std::string& clip, double time,
                                 size_t joint_count, std::string* what);

struct PosedCharacter {
  Character character;
  bool corrected = true;  // false: matrices with shear or unequal scales; the pose is linear skinning
};

//   correction  correction of bends; nullopt: skinning only, linear or by dual quaternions
PosedCharacter pose_character(const Character& character, const std::vector<Affine>& palette,
                              const std::optional<sinew_deform_options>& correction, bool dual_quaternion);

}  // namespace sinew
#endif
