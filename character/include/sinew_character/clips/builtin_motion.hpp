// SPDX-License-Identifier: MIT
// Clips that ship: builtin:walk and others, made from data (src/clips/gaits), in the public domain (CC0).
#ifndef SINEW_CHARACTER_BUILTIN_MOTION_HPP
#define SINEW_CHARACTER_BUILTIN_MOTION_HPP

#include <string>
#include <vector>

#include "sinew_formats/motion.hpp"

namespace sinew {

// builtin:NAME, builtin:KIND/NAME, or builtin:KIND for all clips of a kind of body; each with :VARIANT for another manner.
bool is_builtin_motion(const std::string& path);
// 30 frames a second, facing +z, y up. The last frame is the first one, where the body travels one cycle on. One motion for each kind
// that has a clip of the name. Throws Error with the names there are.
std::vector<Motion> builtin_motions(const std::string& path);

}  // namespace sinew
#endif
