// SPDX-License-Identifier: MIT
// Input of a "rig" network: sets of surface points with the interior behind them, and their neighbors.
#ifndef SINEW_VOTES_RIG_POINTS_HPP
#define SINEW_VOTES_RIG_POINTS_HPP

#include "front/mirror_frame.hpp"
#include "front/surface_points.hpp"
#include "votes/interior.hpp"

namespace sinew::rigging {

// Channels of a point, Q13. Lengths are shares of the longest side; x is counted away from the mirror plane, so that both
// sides look the same ("folded").
enum RigChannel : uint32_t {
  kRigPosition = 0,   // 3: 2 p
  kRigNormal = 3,     // 3: outward
  kRigMedial = 6,     // 3: 2 m, the middle of what lies behind the point
  kRigThickness = 9,  // 4 t
  kRigDepth = 10,     // 8 times the depth of m below the surface
  kRigExtents = 11,   // 6: 4 times the distance from m to the surface along +x -x +y -y +z -z
  kRigDistance = 17,  // from the body's middle, through the body
  kRigRelative = 18,  // 3: (p - mean) / (2 rms)
  kRigBody = 21,      // 6: 1.5 times box x, y, z, rms, mean y, mean z; the same for all points of a set
  kRigChannels = 27
};
constexpr uint32_t kNeighbors = 12;  // near; and as many far ones, each sixth of the 72 nearest
constexpr uint32_t kFarStep = 6;

// One set. Neighbors by position and medial point together, so that two legs are apart.
struct PointSet {
  SurfacePoint* points = nullptr;      // [kSetPoints] as they lie on the mesh; normals are rotated outward
  Vec3i* medial = nullptr;             // [kSetPoints] m, not folded
  int16_t* features = nullptr;         // [kSetPoints x kRigChannels]
  uint32_t* near_neighbors = nullptr;  // [kSetPoints x kNeighbors]
  uint32_t* far_neighbors = nullptr;   // [kSetPoints x kNeighbors]

  static bool on_left(const SurfacePoint& p) { return p.position.x >= 0; }  // +x
  bool allocate(Arena& arena);
};

// Fills a set, allocated beforehand, for a mesh in the mirror frame. Scratch is taken from the arena and released. Returns
// arena.ok().
bool make_point_set(const Mesh& mesh, const Interior& interior, uint64_t seed, Arena& arena, PointSet* set);

}  // namespace sinew::rigging
#endif
