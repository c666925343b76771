// SPDX-License-Identifier: MIT
// A hand cut out of a body and brought to where all hands are alike: along +x, a left one, as long as the grid.
#ifndef SINEW_DETAILS_HAND_CROP_HPP
#define SINEW_DETAILS_HAND_CROP_HPP

#include "mesh/mesh.hpp"

namespace sinew::rigging {

// Where a hand is thought to be. Grid units of the mesh.
struct HandPosition {
  Vec3i wrist = {0, 0, 0};
  Vec3i elbow = {0, 0, 0};  // anywhere behind the wrist: only the direction counts
  int32_t length = 1;       // of the hand, more or less; at least 1
  uint32_t quarters = 0;    // where the body faces, as in MirrorFrame
  bool right = false;
};

// From the mesh's grid to the hand's. The body is rotated to face +z, a right hand is mirrored, the direction from
// elbow to wrist is rotated to +x by the smallest rotation that does it, and the box of what was cut out comes to x
// >= 0, its middle to y = z = 0, its longest side to kSide.
struct HandFrame {
  Vec3i wrist = {0, 0, 0};
  uint32_t quarters = 0;
  bool right = false;
  Vec3i axes[3] = {};         // rows of the rotation, Q28
  Vec3l zero = {0, 0, 0};     // of the box, Q8 grid units, rotated
  int64_t side = kSide << 8;  // of the box, Q8 grid units, at least 1

  Vec3l rotated(Vec3i p) const;  // from the wrist, Q8 grid units
  Vec3i to(Vec3i p) const;
  Vec3i from(Vec3i p) const;
};

// The hand of a mesh with V vertices and T triangles. `mesh` has positions and triangles alone, in the hand's grid;
// triangles from surface_triangles on close holes, so that the voxels have an inside.
struct HandCrop {
  Mesh mesh;
  HandFrame frame;
  uint32_t surface_vertices = 0, surface_triangles = 0;  // without what closes holes; 0: there is no hand
  uint32_t* source = nullptr;                            // [surface_vertices] vertex of the whole mesh

  bool allocate(Arena& arena, const Counts& counts);
};

// Keeps the triangles from a third of a hand's length before the wrist to half a length beyond its end and a length to
// the sides, of these the connected parts that come near the hand's axis, and closes every loop of edges that have one
// triangle by a fan around its middle.
//   counts  of the whole mesh
//   crop    allocated beforehand
// Scratch is taken from the arena and released. Returns arena.ok().
bool crop_hand(const Mesh& mesh, const HandPosition& position, const Counts& counts, Arena& arena, HandCrop* crop);

}  // namespace sinew::rigging
#endif
