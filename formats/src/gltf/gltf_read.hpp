// SPDX-License-Identifier: MIT
// The glTF reader as the other readers call it; io.hpp has the public ways in.
#ifndef SINEW_FORMATS_GLTF_GLTF_READ_HPP
#define SINEW_FORMATS_GLTF_GLTF_READ_HPP

#include <string>

#include "sinew_formats/character.hpp"

namespace sinew {

// As read_gltf; a file with a skeleton but no mesh is fine unless need_mesh.
Character read_gltf_character(const std::string& path, bool need_mesh);

}  // namespace sinew
#endif
