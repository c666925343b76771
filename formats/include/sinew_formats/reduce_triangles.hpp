// SPDX-License-Identifier: MIT
// A character's document with fewer triangles, for levels of detail.
#ifndef SINEW_FORMATS_REDUCE_TRIANGLES_HPP
#define SINEW_FORMATS_REDUCE_TRIANGLES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Vertices that stay keep all that they have: place, normal, texture coordinates, weights, shapes. All meshes are taken together, so that parts
// which touch go on touching; seams of textures and borders stay seams and borders. By meshoptimizer (github.com/zeux/meshoptimizer,
// meshopt_simplify: quadrics of Garland and Heckbert 1997).
//   positions  [V] of the character's vertices where shapes are measured, at rest or in a pose
//   share      of the triangles that shall be left, 0..1; more are left where seams or borders want them
// Returns a GLB. Throws Error for a character without a glTF document, and where this build has no meshoptimizer.
std::vector<uint8_t> reduced_glb(const std::string& name, const Character& character,
                                 const std::vector<Vec3>& positions, double share);

}  // namespace sinew
#endif
