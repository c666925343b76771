// SPDX-License-Identifier: MIT
// Motions as users name them: a file, or a clip that ships.
#ifndef SINEW_CHARACTER_MOTION_FILE_HPP
#define SINEW_CHARACTER_MOTION_FILE_HPP

#include <string>

#include "sinew_formats/motion.hpp"

namespace sinew {

// read_motion(), or of builtin_motions() the one whose body maps best onto the character.
//   up  of the character: "x", "y", "z", or "auto"
Motion read_motion_for(const std::string& path, double fps, const Character& character, const std::string& up = "auto");

}  // namespace sinew
#endif
