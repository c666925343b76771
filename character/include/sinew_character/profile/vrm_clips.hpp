// SPDX-License-Identifier: MIT
// Clips without their character: BVH with the character's joints, VRMA with the humanoid bones of VRM.
#ifndef SINEW_CHARACTER_VRM_CLIPS_HPP
#define SINEW_CHARACTER_VRM_CLIPS_HPP

#include <string>

#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Returns the motion of a character's humanoid bones relative to a T pose, y up and facing +z, with translations of
// the hips only, as in VRMC_vrm_animation. Joints have the names of VRM bones; other joints are merged into their
// ancestors. Throws Error for a body without the required bones of a VRM, or without arms for a T pose.
Motion humanoid_motion(const Character& character, const Motion& motion);

// Writes all clips as .vrma, or the only clip as .bvh. Throws Error.
void write_clips(const std::string& path, const Character& character, const Motion& motion);

}  // namespace sinew
#endif
