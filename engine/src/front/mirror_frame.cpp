// SPDX-License-Identifier: MIT
// The mirror plane by points of the surface: mirrored points should lie near others.
#include "front/mirror_frame.hpp"

#include "core/sort.hpp"
#include "front/point_grid.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kAsked = 1024;  // of the points, those that are mirrored
constexpr int kPlaneRounds = 3;
// Shares of the side: a plane across z has to be so much better than one across x, which must be bad; a plane that was found
// by refining has to be that much better than one that is given.
constexpr uint32_t kRotationError = kSide * 12 / 1000, kRefineGain = kSide / 500;

struct FrameScratch {
  SurfacePoint* points;  // [kMirrorPoints]
  PointGrid grid;
  int32_t* values;  // [kMirrorPoints]
  uint32_t* far;    // [kAsked] distance of a mirrored point to the surface

  bool allocate(Arena& arena) {
    points = arena.alloc<SurfacePoint>(kMirrorPoints);
    (void)grid.allocate(arena, kMirrorPoints);
    values = arena.alloc<int32_t>(kMirrorPoints);
    far = arena.alloc<uint32_t>(kAsked);
    return arena.ok();
  }
};

int32_t coordinate(Vec3i p, int axis) { return axis == 0 ? p.x : p.z; }

// Distance that nine of ten mirrored points keep within, and half the median error along the axis.
uint32_t mirror_error(const FrameScratch& s, int axis, int32_t plane, int32_t* lacking) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < kAsked; ++i) {
    Vec3i p = s.points[i * (kMirrorPoints / kAsked)].position;
    (axis == 0 ? p.x : p.z) = 2 * plane - coordinate(p, axis);
    uint32_t near = 0;
    uint64_t squared = 0;
    s.far[i] = kSide / 8;
    if (!s.grid.nearest(p, &near, &squared)) continue;
    s.far[i] = isqrt64(squared);
    s.values[count++] = coordinate(s.points[near].position, axis) - coordinate(p, axis);
  }
  heap_sort(s.far, kAsked, [](uint32_t a, uint32_t b) { return a < b; });
  *lacking = 0;
  if (count > 0) {
    heap_sort(s.values, count, [](int32_t a, int32_t b) { return a < b; });
    *lacking = static_cast<int32_t>(round_shift(s.values[count / 2], 1));
  }
  return s.far[kAsked * 9 / 10];
}

struct AxisPlane {
  int32_t at;
  uint32_t error;
};

AxisPlane best_plane(const FrameScratch& s, int axis, int32_t middle) {
  int64_t sum = 0;
  for (uint32_t i = 0; i < kMirrorPoints; ++i) {
    s.values[i] = coordinate(s.points[i].position, axis);
    sum += s.values[i];
  }
  heap_sort(s.values, kMirrorPoints, [](int32_t a, int32_t b) { return a < b; });
  const int32_t starts[4] = {middle, 0, s.values[kMirrorPoints / 2], static_cast<int32_t>(round_shift(sum, 12))};
  AxisPlane best = {0, UINT32_MAX}, given = {0, UINT32_MAX};
  for (int i = 0; i < 4; ++i) {
    int32_t at = starts[i];
    bool seen = false;
    for (int before = 0; before < i; ++before) seen = seen || starts[before] == at;
    for (int round = 0; round < kPlaneRounds && !seen; ++round) {
      int32_t lacking = 0;
      const uint32_t error = mirror_error(s, axis, at, &lacking);
      if (error < best.error) best = {at, error};
      if (round == 0 && i < 2 && (given.error == UINT32_MAX || error + kRefineGain < given.error)) given = {at, error};
      if (lacking == 0) break;
      at += lacking;
    }
  }
  return given.error <= best.error + kRefineGain ? given : best;
}

}  // namespace

bool find_mirror_frame(const Mesh& mesh, Mirroring mirroring, const int32_t (&middle)[2], bool upright, Arena& arena,
                       MirrorFrame* frame) {
  const ArenaScope scope(arena);
  FrameScratch s;
  if (!s.allocate(arena)) return false;
  if (arena.measuring()) return true;
  *frame = MirrorFrame();
  if (mirroring == Mirroring::kNever) return true;
  spread_points(mesh, kMirrorPoints, kMirrorSeed, s.points);
  s.grid.build(kMirrorPoints, [&](uint32_t i) { return s.points[i].position; });
  const AxisPlane x = best_plane(s, 0, middle[0]);
  frame->plane = x.at;
  frame->error = x.error;
  if (!upright && x.error > kRotationError) {
    const AxisPlane z = best_plane(s, 1, middle[1]);
    if (uint64_t{z.error} * 10 < uint64_t{x.error} * 6) {
      frame->quarters = 1;
      frame->plane = z.at;
      frame->error = z.error;
    }
  }
  frame->folded = frame->error < kFoldError || mirroring == Mirroring::kAlways;
  if (!frame->folded) {  // as it stands
    frame->quarters = 0;
    frame->plane = 0;
  }
  return true;
}

void apply_mirror_frame(const MirrorFrame& frame, Mesh* mesh) {
  for (uint32_t v = 0; v < mesh->welded_count; ++v) {
    mesh->positions[v] = frame.to(mesh->positions[v]);
    mesh->normals[v] = MirrorFrame::turn(mesh->normals[v], frame.quarters);
  }
}

void turn_frame(uint32_t quarters, MirrorFrame* frame, Mesh* mesh) {
  if (quarters % 4 == 0) return;
  for (uint32_t v = 0; v < mesh->welded_count; ++v) {
    mesh->positions[v] = MirrorFrame::turn(mesh->positions[v], quarters);
    mesh->normals[v] = MirrorFrame::turn(mesh->normals[v], quarters);
  }
  frame->quarters = (frame->quarters + quarters) % 4;
}

}  // namespace sinew::rigging
