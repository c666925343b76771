// SPDX-License-Identifier: MIT
// A mesh that the engine has read: welded, in integers, with neighbors and normals.
#ifndef SINEW_TRAINER_DATA_ENGINE_MESH_HPP
#define SINEW_TRAINER_DATA_ENGINE_MESH_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "front/mirror_frame.hpp"
#include "sinew/sinew.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct EngineMesh {
  std::vector<float> positions;   // [V x 3] the caller's, of which the quantizer took the box
  std::vector<uint32_t> corners;  // [T x 3]
  Workspace block{0};             // that `mesh` stands in
  Mesh mesh;
  GridQuantizer quantizer;
  Counts counts;

  // Throws Error with the name for a mesh that the engine refuses.
  EngineMesh(const std::string& name, const std::vector<std::array<double, 3>>& vertices,
             const std::vector<std::array<uint32_t, 3>>& triangles);
  // Where it is its own mirror image, about the caller's middle if that will do.
  rigging::MirrorFrame mirror_frame() const;
};

// The triangles of a character's faces and the vertices that they have; others would spoil the box.
//   vertices   out  [V] the character's units
//   triangles  out  [T] fans
//   source     out  [V] vertex of the character
// Throws Error where there are no faces.
void surface_of(const Character& character, std::vector<std::array<double, 3>>* vertices,
                std::vector<std::array<uint32_t, 3>>* triangles, std::vector<uint32_t>* source);

}  // namespace sinew
#endif
