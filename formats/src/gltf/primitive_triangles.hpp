// SPDX-License-Identifier: MIT
// The triangles of a primitive, whatever they are listed as.
#ifndef SINEW_FORMATS_GLTF_PRIMITIVE_TRIANGLES_HPP
#define SINEW_FORMATS_GLTF_PRIMITIVE_TRIANGLES_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gltf/tinygltf.hpp"

namespace sinew {

// Of lists, strips and fans, in the order in which a Character has them as faces.
//   vertex_count  of the primitive
// Throws Error naming `where` for indices that name no vertex, or a list that is not in threes.
std::vector<std::array<uint32_t, 3>> primitive_triangles(const std::string& where, const tinygltf::Model& model,
                                                         const tinygltf::Primitive& primitive, size_t vertex_count);

}  // namespace sinew
#endif
