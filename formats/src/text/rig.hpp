// SPDX-License-Identifier: MIT
// The rig.txt reader as the other readers call it; io.hpp has the public ways in.
#ifndef SINEW_FORMATS_TEXT_RIG_HPP
#define SINEW_FORMATS_TEXT_RIG_HPP

#include <string>

#include "sinew_formats/character.hpp"

namespace sinew {

// Replaces joints and influences of `character`; with_skin needs its vertices to be those the skin lines number. Throws
// Error with the line before anything is replaced.
void read_rig(const std::string& path, bool with_skin, Character* character);

}  // namespace sinew
#endif
