// SPDX-License-Identifier: MIT
#include "gltf/primitive_triangles.hpp"

#include <utility>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

std::vector<std::array<uint32_t, 3>> primitive_triangles(const std::string& where, const tinygltf::Model& model,
                                                         const tinygltf::Primitive& primitive, size_t vertex_count) {
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = accessor_integers(where + ", indices", model, primitive.indices, 1);
    for (const uint32_t index : indices)
      if (index >= vertex_count)
        throw Error(where + ": expected indices below " + std::to_string(vertex_count) + ", found " +
                    std::to_string(index));
  } else {
    for (size_t v = 0; v < vertex_count; ++v) indices.push_back(static_cast<uint32_t>(v));
  }
  const bool list = primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP && primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN;
  if (list && indices.size() % 3 != 0)
    throw Error(where + ": expected indices in threes, found " + std::to_string(indices.size()));
  std::vector<std::array<uint32_t, 3>> triangles;
  for (size_t i = 2; i < indices.size(); i += list ? 3 : 1) {
    std::array<uint32_t, 3> corners = {indices[i - 2], indices[i - 1], indices[i]};
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1) std::swap(corners[1], corners[2]);
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) corners[0] = indices[0];
    triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace sinew
