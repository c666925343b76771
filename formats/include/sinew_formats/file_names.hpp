// SPDX-License-Identifier: MIT
// How file names are read: extensions without regard to case, the stem that names a character, the rig beside a mesh.
#ifndef SINEW_FORMATS_FILE_NAMES_HPP
#define SINEW_FORMATS_FILE_NAMES_HPP

#include <string>

namespace sinew {

bool has_extension(const std::string& path, const char* extension);  // ".glb"; the name must be longer than that
std::string stem_of(const std::string& path);                        // folder/NAME.rig.txt -> NAME, "-" -> stdin
std::string rig_path_beside(const std::string& mesh_path);           // folder/NAME.obj -> folder/NAME.rig.txt

}  // namespace sinew
#endif
