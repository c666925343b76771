// SPDX-License-Identifier: MIT
// Built-in clips: builtin:walk and others, generated from data (src/clips/gaits), in the public domain (CC0).
#ifndef SINEW_CHARACTER_BUILTIN_MOTION_HPP
#define SINEW_CHARACTER_BUILTIN_MOTION_HPP

#include <string>
#include <vector>

#include "sinew_formats/motion.hpp"

namespace sinew {

// builtin:NAME, builtin:KIND/NAME, or builtin:KIND for all clips of a kind of body; each with :VARIANT for another
// style.
bool is_builtin_motion(const std::string& path);
// Makes one motion per kind of body that has a clip of this name: 30 frames per second, facing +z, y up. The last
// frame equals the first one, a cycle further on if the body travels. Throws Error that lists the names.
std::vector<Motion> builtin_motions(const std::string& path);

}  // namespace sinew
#endif
