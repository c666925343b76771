// SPDX-License-Identifier: MIT
// Checks COLLADA's lists of whole numbers before Assimp reads them: its reader does not terminate in a list with a
// character that is not part of a number.
#ifndef SINEW_FORMATS_GLTF_COLLADA_LISTS_HPP
#define SINEW_FORMATS_GLTF_COLLADA_LISTS_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace sinew {

// Throws Error with the line of the first wrong character in <p>, <h>, <v> or <vcount> of a geometry or a controller. Anything else that
// is wrong is left for Assimp.
void check_collada_lists(const std::string& path, const std::vector<uint8_t>& file);

}  // namespace sinew
#endif
