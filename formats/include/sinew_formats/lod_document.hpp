// SPDX-License-Identifier: MIT
// Levels of detail in one glTF file.
#ifndef SINEW_FORMATS_LOD_DOCUMENT_HPP
#define SINEW_FORMATS_LOD_DOCUMENT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Combines GLBs: each mesh node of the first one lists those of the others in the extension MSFT_lod. They share its
// joints, skins, materials and pictures; programs without the extension show only the first level. Each level is for
// half the screen height of the one before.
//   levels  of one document with different meshes, the full one first
// Throws Error, which begins with `path`, for levels whose nodes, materials or skins differ.
std::vector<uint8_t> glb_of_levels(const std::string& path, const std::vector<std::vector<uint8_t>>& levels);

// Makes one level: a character with fewer triangles.
// Remaining vertices keep their data: position, normal, texture coordinates, weights, shapes. All meshes are reduced
// together, so that touching parts stay in touch. Texture seams and borders are kept, unless there are so many of
// them (flat shading, unjoined corners) that the share could not be reached. By meshoptimizer
// (github.com/zeux/meshoptimizer, meshopt_simplify: quadrics of Garland and Heckbert 1997).
//   positions  [V] positions of the character's vertices for measuring shapes, at rest or in a pose
//   share      share of the triangles to keep, 0..1; more are kept for seams or borders
// Returns a GLB. Throws Error for a character without a glTF document, and in a build without meshoptimizer.
std::vector<uint8_t> reduced_glb(const std::string& name, const Character& character,
                                 const std::vector<Vec3>& positions, double share);

}  // namespace sinew
#endif
