// SPDX-License-Identifier: MIT
// A glTF node's own transform as translation, rotation and scale: what animations change.
#ifndef SINEW_FORMATS_GLTF_NODE_PARTS_HPP
#define SINEW_FORMATS_GLTF_NODE_PARTS_HPP

#include <algorithm>
#include <cmath>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/base/affine.hpp"

namespace sinew {

struct NodeParts {
  Point3 translation = {0, 0, 0}, scale = {1, 1, 1};
  Quaternion rotation = kNoRotation4;

  Affine affine() const {
    const Rotation r = rotation_of(rotation);
    Affine m{};
    for (size_t row = 0; row < 3; ++row) {
      for (size_t c = 0; c < 3; ++c) m[4 * row + c] = r[3 * row + c] * scale[c];
      m[4 * row + 3] = translation[row];
    }
    return m;
  }
};

// For a matrix with shear, the nearest parts.
inline NodeParts parts_of(const tinygltf::Node& node) {
  NodeParts parts;
  if (node.matrix.size() == 16) {
    Affine m{};
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 4; ++c) m[r * 4 + c] = node.matrix[c * 4 + r];
    parts.rotation = quaternion_of(rotation_part(m));
    const Rotation r = rotation_of(parts.rotation);
    for (size_t i = 0; i < 3; ++i) {
      parts.translation[i] = m[4 * i + 3];
      const double along = m[i] * r[i] + m[4 + i] * r[3 + i] + m[8 + i] * r[6 + i];  // negative where it mirrors
      parts.scale[i] = std::copysign(std::hypot(m[i], m[4 + i], m[8 + i]), along);
    }
    return parts;
  }
  if (node.translation.size() == 3) std::copy_n(node.translation.begin(), 3, parts.translation.begin());
  if (node.scale.size() == 3) std::copy_n(node.scale.begin(), 3, parts.scale.begin());
  if (node.rotation.size() == 4) {
    std::copy_n(node.rotation.begin(), 4, parts.rotation.begin());
    parts.rotation = normalized(parts.rotation);
  }
  return parts;
}

// The parts of an animated transform of a node with the parts `rest`: scales keep their signs.
inline NodeParts parts_of(Affine local, const NodeParts& rest) {
  NodeParts parts;
  for (size_t c = 0; c < 3; ++c) {
    parts.translation[c] = local[4 * c + 3];
    parts.scale[c] = std::copysign(std::hypot(local[c], local[4 + c], local[8 + c]), rest.scale[c]);
    if (rest.scale[c] < 0)  // mirrored: the rotation is what is left
      for (size_t r = 0; r < 3; ++r) local[4 * r + c] = -local[4 * r + c];
  }
  parts.rotation = quaternion_of(rotation_part(local));
  return parts;
}

}  // namespace sinew
#endif
