// SPDX-License-Identifier: MIT
// Where a mesh's mirror plane lies, and the mesh brought there.
#ifndef SINEW_FRONT_MIRROR_FRAME_HPP
#define SINEW_FRONT_MIRROR_FRAME_HPP

#include "front/surface_points.hpp"

namespace sinew::rigging {

// Points of the surface that a plane is found by, and their seed; as near as this, a mirrored point lies on the surface.
constexpr uint32_t kMirrorPoints = 4096;
constexpr uint64_t kMirrorSeed = 11;
constexpr uint32_t kFoldError = kSide * 3 / 100;

enum class Mirroring : uint8_t { kAuto, kAlways, kNever };

// From the mesh's grid to the mirror frame, in rotations by 90 degrees about y: the plane comes to x = 0, and what faces along +z, +x,
// -z or -x (0 to 3 quarters) faces along +z then. Odd quarters have a plane across z.
struct MirrorFrame {
  bool folded = false;  // the mesh is near enough to its mirror image
  uint32_t quarters = 0;
  int32_t plane = 0;   // where, grid units
  uint32_t error = 0;  // how far a mirrored point lies from the surface, 90 % of them, grid units

  bool turned() const { return (quarters & 1) != 0; }
  Vec3i to(Vec3i p) const {
    return turn(turned() ? Vec3i{p.x, p.y, p.z - plane} : Vec3i{p.x - plane, p.y, p.z}, quarters);
  }
  Vec3i from(Vec3i p) const {
    const Vec3i q = turn(p, 4 - quarters);
    return turned() ? Vec3i{q.x, q.y, q.z + plane} : Vec3i{q.x + plane, q.y, q.z};
  }
  static Vec3i turn(Vec3i p, uint32_t quarters) {
    switch (quarters % 4) {
      case 1:
        return {-p.z, p.y, p.x};
      case 2:
        return {-p.x, p.y, -p.z};
      case 3:
        return {p.z, p.y, -p.x};
      default:
        return p;
    }
  }
};

// Looks across x at `middle` (where the caller's x is 0), at the box's middle, at the points' median and mean, and near
// these; and the same across z, which has to be clearly better. Scratch is taken from the arena and released.
//   middle   grid units; the caller's x = 0, and z = 0
//   upright  the mesh faces along z already: the plane is across x
// Returns arena.ok(); frame is only written by a real arena.
bool find_mirror_frame(const Mesh& mesh, Mirroring mirroring, const int32_t (&middle)[2], bool upright, Arena& arena,
                       MirrorFrame* frame);
// Moves the mesh's vertices and normals into the frame.
void apply_mirror_frame(const MirrorFrame& frame, Mesh* mesh);
// Rotates a mesh in its frame by further multiples of 90 degrees, and updates the frame.
void turn_frame(uint32_t quarters, MirrorFrame* frame, Mesh* mesh);

}  // namespace sinew::rigging
#endif
