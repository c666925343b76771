// SPDX-License-Identifier: MIT
// Clips without their character: BVH as the character's joints are, VRMA on the humanoid bones that every VRM has.
#ifndef SINEW_CHARACTER_VRM_CLIPS_HPP
#define SINEW_CHARACTER_VRM_CLIPS_HPP

#include <string>

#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// The motion of a character's humanoid bones against a T pose, y up and facing +z, hips alone moving, as VRMC_vrm_animation wants it. Joints are
// called as VRM's bones; what is none of them goes with the bone above it.
// Throws Error for a body that lacks bones that a VRM must have, and one without arms that could be stretched.
Motion humanoid_motion(const Character& character, const Motion& motion);

// All clips as .vrma, or the one clip as .bvh. Throws Error.
void write_clips(const std::string& path, const Character& character, const Motion& motion);

}  // namespace sinew
#endif
