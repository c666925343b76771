// SPDX-License-Identifier: MIT
// A character from whatever its file is, and back by the extension.
#ifndef SINEW_CHARACTER_CHARACTER_FILE_HPP
#define SINEW_CHARACTER_CHARACTER_FILE_HPP

#include <string>

#include "sinew_formats/character.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

struct CharacterFile {
  Character character;
  bool own_skeleton = true;  // the skeleton is in the mesh's own file
};

// A mesh with the skeleton of its own file or, NAME.obj, of NAME.rig.txt beside it (in notes where that cannot be used); a .rig.txt with
// its NAME.obj; a skeleton alone from .rig.txt, .bvh, or a file with joints and no mesh. Throws Error.
CharacterFile open_character(const std::string& path);

// .glb, .gltf, .vrm with motion and shapes; .obj (with .rig.txt beside it when there are joints), .rig.txt; "-" is rig.txt on standard
// output.
void write_character(const std::string& path, const Character& character, const GlbOptions& options = {},
                     const Morphs& morphs = {});

}  // namespace sinew
#endif
