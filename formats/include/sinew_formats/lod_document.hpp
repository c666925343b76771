// SPDX-License-Identifier: MIT
// Levels of detail in one glTF file.
#ifndef SINEW_FORMATS_LOD_DOCUMENT_HPP
#define SINEW_FORMATS_LOD_DOCUMENT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// The first GLB, each of whose mesh nodes names those of the others in its extension MSFT_lod. They share its joints, skins, materials and
// pictures; programs that do not know the extension see the first level alone. A level is for half the height on the screen of the one before.
//   levels  of one document with other meshes, the whole one first
// Throws Error, which begins with `path`, for levels whose nodes, materials or skins differ.
std::vector<uint8_t> glb_of_levels(const std::string& path, const std::vector<std::vector<uint8_t>>& levels);

// One level: a character with fewer triangles.
// Vertices that stay keep all that they have: position, normal, texture coordinates, weights, shapes. All meshes are taken together, so that parts
// which touch go on touching; seams of textures and borders stay seams and borders, unless so much is seam (flat shading, corners that were never
// joined) that the share is missed. By meshoptimizer (github.com/zeux/meshoptimizer,
// meshopt_simplify: quadrics of Garland and Heckbert 1997).
//   positions  [V] of the character's vertices where shapes are measured, at rest or in a pose
//   share      of the triangles that shall be left, 0..1; more are left where seams or borders want them
// Returns a GLB. Throws Error for a character without a glTF document, and where this build has no meshoptimizer.
std::vector<uint8_t> reduced_glb(const std::string& name, const Character& character,
                                 const std::vector<Vec3>& positions, double share);

}  // namespace sinew
#endif
