// SPDX-License-Identifier: MIT
// Values of an accessor for chosen vertices, as a new accessor.
#ifndef SINEW_FORMATS_GLTF_PICK_VERTICES_HPP
#define SINEW_FORMATS_GLTF_PICK_VERTICES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// In the kind of number that the accessor has, floats of a sparse one.
//   read       the document as it was read, which `accessor` is of
//   vertices   which values, in their order; one may be there twice
//   all_stay   every value is among them: bounds stay those that the accessor has; else they are found
//   written    gets the new accessor
// Returns its number. Throws Error naming `where` for a vertex that has no value.
int pick_vertices(const std::string& where, const GltfSource& read, int accessor, const std::vector<uint32_t>& vertices,
                  bool all_stay, GltfSource* written);

}  // namespace sinew
#endif
