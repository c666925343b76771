// SPDX-License-Identifier: MIT
// A mesh's surface: vertices at equal positions, neighbors, and the area that moves with each joint.
#ifndef SINEW_CHARACTER_RIG_MESH_SURFACE_HPP
#define SINEW_CHARACTER_RIG_MESH_SURFACE_HPP

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Disjoint sets of vertices, each identified by its smallest member.
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

// Returns [V] the first vertex with the same position: meshes are split at seams of normals and textures, surfaces
// are not.
std::vector<uint32_t> first_at_position(const Character& character);
// Returns [V] one-rings over the result of first_at_position(), so that split vertices do not cut the surface: unique
// neighbors along edges, ascending; empty for vertices that are not the first at their position.
std::vector<std::vector<uint32_t>> welded_rings(const Character& character, const std::vector<uint32_t>& first);

// Returns [V] the vertices at the other end of each edge, once per face with that edge, and the other vertices at the
// same position, so that walks continue across split vertices.
std::vector<std::vector<uint32_t>> neighbors_of(const Character& character);

// Connected pieces of a surface over first_at_position().
struct MeshParts {
  std::vector<uint32_t> part;  // [V] identified by their first vertices
  size_t count = 0;
};
MeshParts connected_parts(const Character& character);

// Some vertices of a mesh with their faces, joints and weights, as a separate Character.
struct MeshPart {
  Character character;
  std::vector<size_t> vertices;  // [part's V] -> the whole's
};
// Returns the mesh without some vertices and their faces.
//   left_out  [V] 1: removed
MeshPart part_without(const Character& whole, const std::vector<uint8_t>& left_out);

// Triangulates faces as fans from their first corners: vertex indices.
std::vector<std::array<uint32_t, 3>> fan_triangles(const Character& character);

// The surface that moves with each joint: share and centroid.
struct JointSurfaces {
  std::vector<float> shares;     // [J] of the whole
  std::vector<float> centroids;  // [J x 3] the joint's position if nothing moves with it
};

// Uses vertices as samples, each with a third of the area of the triangles around it, or equal areas without a
// surface, as in a rig.txt without its mesh. Empty without weights.
JointSurfaces joint_surfaces(const Character& character);

}  // namespace sinew
#endif
