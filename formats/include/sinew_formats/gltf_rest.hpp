// SPDX-License-Identifier: MIT
// A glTF's skins as the file shows them while nothing moves, against the pose that they were bound in.
#ifndef SINEW_FORMATS_GLTF_REST_HPP
#define SINEW_FORMATS_GLTF_REST_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct GltfRest {
  bool agrees = true;             // the inverse bind matrices know one pose
  std::vector<Affine> shown;      // [J] skinning matrices from the character's vertices to where the file shows them
  std::vector<uint8_t> mirrored;  // [J] 1: the joint's node is scaled by a negative number
  std::vector<double> uneven;  // [J] largest over smallest scale along the node's axes, 1 for one that is scaled evenly
};

// Of a character that was read from a glTF (or from what becomes one) and has its joints; nullopt for others. Throws Error for a document
// whose matrices cannot be read.
std::optional<GltfRest> gltf_rest(const Character& character);

}  // namespace sinew
#endif
