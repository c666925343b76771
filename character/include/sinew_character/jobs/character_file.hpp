// SPDX-License-Identifier: MIT
// Reads a character from any supported file, and writes it by extension.
#ifndef SINEW_CHARACTER_CHARACTER_FILE_HPP
#define SINEW_CHARACTER_CHARACTER_FILE_HPP

#include <string>

#include "sinew_formats/character.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

struct CharacterFile {
  Character character;
  bool own_skeleton = true;  // the skeleton is from the mesh's own file
};

// Reads a mesh with the skeleton of its file or, for NAME.obj, of NAME.rig.txt beside it (with a note if that is
// unusable); a .rig.txt with its NAME.obj; or only a skeleton from .rig.txt, .bvh, or a file with joints and no mesh.
// Throws Error.
CharacterFile open_character(const std::string& path);

// Writes .glb, .gltf, .vrm with motion and shapes; .obj (with .rig.txt beside it if there are joints), .rig.txt; "-"
// is rig.txt on standard output.
void write_character(const std::string& path, const Character& character, const GlbOptions& options = {},
                     const Morphs& morphs = {});

}  // namespace sinew
#endif
