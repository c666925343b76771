// SPDX-License-Identifier: MIT
// Steps of find_seams(): the surface, how far joints are apart along the skeleton, and which joint each vertex belongs to.
#ifndef SINEW_CHARACTER_BIND_SEAM_STEPS_HPP
#define SINEW_CHARACTER_BIND_SEAM_STEPS_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "sinew_character/bind/seams.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The surface on which seams are looked for: welded vertices, their edges, normals and creases.

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

// A point on a joint's bones.
struct BonePoint {
  uint32_t joint = 0;
  uint32_t bone = 0;    // one for each child, or the stub of a leaf
  double along = 0;     // 0 at the joint, 1 at the bone's end
  double distance = 0;  // from where it was looked for
  Point3 position = {};
};

class SkeletonPaths {
 public:
  //   size  the mesh's longest side
  SkeletonPaths(const std::vector<Joint>& joints, double size);

  size_t joint_count() const { return positions_.size(); }
  // The nearest point on the bones of `joint`: segments to its children, of a leaf half its parent's bone on.
  BonePoint nearest(uint32_t joint, const Point3& from) const;
  // Along the bones; straight from limb to limb if both have the same parent, so that hierarchies in which a root at
  // the floor is the parent of all limbs work too. Negative where nothing joins them.
  double length(const BonePoint& a, const BonePoint& b) const;
  // Whether parts of the body that move apart meet where these two are near: the path is longer than 15 % of the size, and than two and
  // a half times the straight distance.
  bool are_apart(const BonePoint& a, const BonePoint& b) const;

 private:
  double size_;
  std::vector<Point3> positions_;           // [J]
  std::vector<int> parents_, depths_;       // [J]
  std::vector<std::vector<Point3>> bones_;  // [J] from the joint to the end of each bone
};

// Joint of the largest weight, the first of those that are equal; kNoHome without weight.
uint32_t home_joint(const std::vector<Influence>& row);

// Decides the homes of the welded vertices of a band anew.
//   band   welded vertices, ascending
//   homes  in/out [V] of welded vertices: each one's strongest joint, kNoHome without weights
void find_seam_homes(const SeamSurface& surface, const SkeletonPaths& paths, const WeightRows& rows,
                     const std::vector<uint32_t>& band, std::vector<uint32_t>* homes);

}  // namespace sinew
#endif
