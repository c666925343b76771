// SPDX-License-Identifier: MIT
// Which faces stand between a vertex and a bone: a bounding-box tree over the triangles and an exact integer
// segment/triangle test (stage 4, before the sources are chosen).
#ifndef SINEW_HEAT_VISIBILITY_HPP
#define SINEW_HEAT_VISIBILITY_HPP

#include "kernels/boxes.hpp"
#include "mesh/mesh.hpp"

namespace sinew {

// True when the open segment start -> target crosses triangle (a, b, c) from its front: it runs against the normal
// (b - a) x (c - a), meets the closed triangle, and the meeting point is neither start nor target. A segment inside the
// triangle's plane does not cross it. Exact for mesh points (inside a box of side 2^20 that holds `start`, too) and
// |target| <= 2^23 per axis.
bool crosses_front(Vec3i start, Vec3i target, Vec3i a, Vec3i b, Vec3i c);
// The same with 96-bit determinants, whatever the length of the segment; the function above uses it for long segments.
bool crosses_front_wide(Vec3i start, Vec3i target, Vec3i a, Vec3i b, Vec3i c);

// Triangles grouped by part, inside a part in the mesh's own order (Morton order of their first vertex), so
// that consecutive triangles are near each other and a tree over runs of them needs no sorting: a triangle has a box
// (two in one made fewer groups to look at, but five times the triangles), kBoxesInGroup boxes make a group, and the
// box around a group is one of the next level.
struct FaceTree {
  static constexpr uint32_t kMostLevels = 8;  // 16^8 triangles are more than there can be
  static constexpr uint32_t kNoGroup = 0xFFFFFFFFu;

  uint32_t* order = nullptr;       // [T] triangle at each slot
  uint32_t* part_first = nullptr;  // [part_count + 1] first slot of each part
  BoxGroup* groups = nullptr;      // level by level, leaves first
  uint32_t level_first[kMostLevels] = {};
  uint32_t levels = 0;  // the last one has one group; 0 without triangles
  BoxKernel boxes_met = boxes_met_ref;

  bool allocate(Arena& arena, const Counts& counts);
  void build(const Mesh& mesh);
  // True when a face at a slot in [first, last) (outside = false) or at any other slot (outside = true), not incident
  // to `vertex`, is crossed from its front on the segment to `target`. *hint is a group to try first and receives
  // that of the face that hides (kNoGroup to start with); it changes the time, never the answer.
  bool hidden(const Mesh& mesh, uint32_t vertex, Vec3i target, uint32_t first, uint32_t last, bool outside,
              uint32_t* hint) const;
};

}  // namespace sinew
#endif
