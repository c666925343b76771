// SPDX-License-Identifier: MIT
// A mesh's surface: which vertices lie at one position and beside each other, and how much of it moves with each joint.
#ifndef SINEW_CHARACTER_RIG_MESH_SURFACE_HPP
#define SINEW_CHARACTER_RIG_MESH_SURFACE_HPP

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Sets of vertices that are joined, each known by its least member.
class VertexGroups {
 public:
  explicit VertexGroups(size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), 0u); }
  uint32_t of(uint32_t v) {
    while (of_[v] != v) v = of_[v] = of_[of_[v]];
    return v;
  }
  void join(uint32_t a, uint32_t b) {
    const uint32_t one = of(a), other = of(b);
    of_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<uint32_t> of_;
};

// [V] the first vertex with the same position: meshes are cut at seams of normals and textures, surfaces are not.
std::vector<uint32_t> first_at_position(const Character& character);
// [V] one-rings over what first_at_position() gave, so that seams and split vertices do not cut the surface: neighbors along edges, each
// once, ascending; empty for vertices that are not the first at their position.
std::vector<std::vector<uint32_t>> welded_rings(const Character& character, const std::vector<uint32_t>& first);

// [V] the vertices at the other end of an edge, once for each face that has it; and of two vertices at one position each has the
// other, so that walks go on across seams.
std::vector<std::vector<uint32_t>> neighbors_of(const Character& character);

// Pieces of a surface that hang together over first_at_position().
struct MeshParts {
  std::vector<uint32_t> part;  // [V] by their first vertices
  size_t count = 0;
};
MeshParts connected_parts(const Character& character);

// Some vertices of a mesh with their faces, joints and weights, as a Character of its own.
struct MeshPart {
  Character character;
  std::vector<size_t> vertices;  // [part's V] -> the whole's
};
// Without some vertices, and without the faces that have one of those.
//   left_out  [V] 1 for those
MeshPart part_without(const Character& whole, const std::vector<uint8_t>& left_out);

// Faces cut into triangles from their first corners: numbers of vertices.
std::vector<std::array<uint32_t, 3>> fan_triangles(const Character& character);

// The surface that moves with each joint: how much of it, and where its middle is.
struct JointSurfaces {
  std::vector<float> shares;     // [J] of the whole
  std::vector<float> centroids;  // [J x 3] the joint's position where nothing moves with it
};

// Vertices are the samples, each as large as a third of the triangles around it; all alike where there is no surface, as in a
// rig.txt without its mesh. Empty without weights.
JointSurfaces joint_surfaces(const Character& character);

}  // namespace sinew
#endif
