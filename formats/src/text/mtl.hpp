// SPDX-License-Identifier: MIT
// Materials of an OBJ: what its .mtl files say of those that it uses.
#ifndef SINEW_FORMATS_TEXT_MTL_HPP
#define SINEW_FORMATS_TEXT_MTL_HPP

#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Fills character->materials from `libraries`, the words after mtllib, relative to the OBJ's folder: Kd, Ke, d, Tr,
// map_Kd, norm, map_Bump. What is missing or malformed becomes a note; a material that no file describes stays white.
void read_materials(const std::string& obj_path, const std::vector<std::string>& libraries, Character* character);

}  // namespace sinew
#endif
