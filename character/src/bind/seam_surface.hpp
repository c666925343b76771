// SPDX-License-Identifier: MIT
// The surface on which seams are looked for: welded vertices, their edges, normals and creases.
#ifndef SINEW_CHARACTER_RIG_SEAM_SURFACE_HPP
#define SINEW_CHARACTER_RIG_SEAM_SURFACE_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

constexpr size_t kFewestEdges = 8;  // of a seam

// [F] 1: the face belongs to a connected part that encloses a negative volume, so that outside sees its corners in reverse order. A mesh
// with all faces reversed has the opposite answers.
//   welded  of first_at_position()
std::vector<char> faces_inside_out(const Character& character, const std::vector<uint32_t>& welded);

struct SurfaceEdge {
  uint32_t from = 0, to = 0;  // welded: indices of Character's vertices
  double length = 0;
  double turn = 0;  // of the smoothed normals along the edge: above 0 where the surface bulges, below in a valley
};

struct SeamSurface {
  double size = 0;                 // the box's longest side
  std::vector<uint32_t> welded;    // [V] the first vertex at the same position
  std::vector<Point3> positions;   // [V]
  std::vector<Point3> normals;     // [V] of welded vertices; zero where they cancel
  std::vector<SurfaceEdge> edges;  // each once, ascending
  std::vector<uint32_t> offsets;   // [V + 1] CSR into `around`
  std::vector<uint32_t> around;    // edges of a welded vertex

  explicit SeamSurface(const Character& character);

  uint32_t other_end(uint32_t edge, uint32_t vertex) const {
    return edges[edge].from == vertex ? edges[edge].to : edges[edge].from;
  }
  // [V] lengths along edges from the nearest of `starts`, infinite beyond `most`.
  std::vector<double> distances(const std::vector<uint32_t>& starts, double most) const;

 private:
  void find_edges(const Character& character);
  void find_normals(const Character& character);
};

}  // namespace sinew
#endif
