// SPDX-License-Identifier: MIT
// Where a mesh's mirror plane lies, and the mesh brought there.
#ifndef SINEW_RIG_MIRROR_FRAME_HPP
#define SINEW_RIG_MIRROR_FRAME_HPP

#include "rig/surface_points.hpp"

namespace sinew {

enum class Mirroring : uint8_t { kAuto, kAlways, kNever };

// From the mesh's grid to the mirror frame: x' = x - plane for a plane across x; x' = plane - z, z' = x for one across z,
// as of a mesh that faces along x. y stays.
struct MirrorFrame {
  bool folded = false;  // the mesh is near enough to its mirror image
  bool turned = false;  // the plane is across z
  int32_t plane = 0;    // where, grid units
  uint32_t error = 0;   // how far a mirrored point lies from the surface, 90 % of them, grid units

  Vec3i to(Vec3i p) const { return turned ? Vec3i{plane - p.z, p.y, p.x} : Vec3i{p.x - plane, p.y, p.z}; }
  Vec3i from(Vec3i p) const { return turned ? Vec3i{p.z, p.y, plane - p.x} : Vec3i{p.x + plane, p.y, p.z}; }
};

// Looks across x at `middle` (where the caller's x is 0), at the box's middle, at the points' median and mean, and near
// these; and the same across z, which has to be clearly better. Scratch is taken from the arena and released.
//   middle  grid units; the caller's x = 0, and z = 0
// Returns arena.ok(); frame is only written by a real arena.
bool find_mirror_frame(const Mesh& mesh, Mirroring mirroring, const int32_t (&middle)[2], Arena& arena,
                       MirrorFrame* frame);
// Moves the mesh's vertices and normals into the frame.
void apply_mirror_frame(const MirrorFrame& frame, Mesh* mesh);

}  // namespace sinew
#endif
