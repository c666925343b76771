// SPDX-License-Identifier: MIT
// The mirror plane by points of the surface: mirrored points should lie near others.
#include "rig/mirror_frame.hpp"

#include <string.h>

#include "core/sort.hpp"

namespace sinew {
namespace {

constexpr uint32_t kPoints = 4096, kAsked = 1024;  // points of the surface; of these, those that are mirrored
constexpr uint64_t kSeed = 11;
constexpr int kRounds = 3;
// Shares of the side: as near as this is symmetric; a plane across z has to be so much better than one across x, which
// must be bad; a plane that was found by refining has to be that much better than one that is given.
constexpr uint32_t kFoldError = kSide * 3 / 100, kRotationError = kSide * 12 / 1000, kRefineGain = kSide / 500;

// Points in cells of a coarse grid, for the nearest of them. Cells along x follow each other, so that a row of them is one
// run of points.
constexpr int kCells = 32, kCellBits = kGridBits - 5;
constexpr int32_t kReach = 2;  // cells around; farther is as good as nothing

struct PointGrid {
  const SurfacePoint* points = nullptr;
  Vec3i low = {0, 0, 0};
  uint32_t* starts = nullptr;  // [kCells^3 + 1]
  uint16_t* order = nullptr;   // [kPoints] points by cell
  Vec3i* positions = nullptr;  // [kPoints] where they are, in that order

  static int32_t cell(int32_t offset) { return clamp32(offset >> kCellBits, 0, kCells - 1); }
  uint32_t cell_of(Vec3i p) const {
    return static_cast<uint32_t>((cell(p.z - low.z) * kCells + cell(p.y - low.y)) * kCells + cell(p.x - low.x));
  }
  void build() {
    low = points[0].position;
    for (uint32_t i = 1; i < kPoints; ++i) {
      const Vec3i p = points[i].position;
      low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
    }
    memset(starts, 0, (kCells * kCells * kCells + 1) * sizeof(uint32_t));
    for (uint32_t i = 0; i < kPoints; ++i) ++starts[cell_of(points[i].position) + 1];
    for (uint32_t c = 0; c < kCells * kCells * kCells; ++c) starts[c + 1] += starts[c];
    for (uint32_t i = kPoints; i-- > 0;) order[--starts[cell_of(points[i].position) + 1]] = static_cast<uint16_t>(i);
    // Every start has moved to the cell before it.
    for (uint32_t c = 0; c < kCells * kCells * kCells; ++c) starts[c] = starts[c + 1];
    starts[kCells * kCells * kCells] = kPoints;
    for (uint32_t e = 0; e < kPoints; ++e) positions[e] = points[order[e]].position;
  }
  // How far an offset from `low` is beyond cells first..last of an axis, 0 within them.
  static int64_t beyond(int32_t offset, int32_t first, int32_t last) {
    const int64_t from = int64_t{first} << kCellBits, to = (int64_t{last} + 1) << kCellBits;
    return offset < from ? from - offset : offset > to ? offset - to : 0;
  }
  // Nearest point within kReach cells, the lowest of several, and the squared distance; false when there is none.
  bool nearest(Vec3i p, uint32_t* index, uint64_t* squared) const {
    *squared = UINT64_MAX;
    const int32_t off[3] = {p.x - low.x, p.y - low.y, p.z - low.z};
    const int32_t at[3] = {cell(off[0]), cell(off[1]), cell(off[2])};
    for (int32_t reach = 1; reach <= kReach; ++reach) {
      int32_t first[3], last[3];
      int64_t inside = INT64_MAX;  // no point beyond these cells is nearer
      for (int axis = 0; axis < 3; ++axis) {
        first[axis] = at[axis] > reach ? at[axis] - reach : 0;
        last[axis] = at[axis] + reach < kCells ? at[axis] + reach : kCells - 1;
        const int64_t below = off[axis] - (int64_t{first[axis]} << kCellBits);
        const int64_t above = ((int64_t{last[axis]} + 1) << kCellBits) - off[axis];
        if (first[axis] > 0 && below < inside) inside = below;
        if (last[axis] < kCells - 1 && above < inside) inside = above;
      }
      for (int32_t z = first[2]; z <= last[2]; ++z) {
        const int64_t dz = beyond(off[2], z, z);
        for (int32_t y = first[1]; y <= last[1]; ++y) {
          const int64_t dy = beyond(off[1], y, y);
          if (static_cast<uint64_t>(dz * dz + dy * dy) > *squared) continue;
          const uint32_t row = static_cast<uint32_t>((z * kCells + y) * kCells);
          const uint32_t end = starts[row + static_cast<uint32_t>(last[0]) + 1];
          for (uint32_t e = starts[row + static_cast<uint32_t>(first[0])]; e < end; ++e) {
            const Vec3i d = positions[e] - p;
            const uint64_t own = static_cast<uint64_t>(dot(d, d));
            if (own < *squared || (own == *squared && order[e] < *index)) {
              *squared = own;
              *index = order[e];
            }
          }
        }
      }
      if (inside > 0 && *squared < static_cast<uint64_t>(inside) * static_cast<uint64_t>(inside)) break;
    }
    return *squared != UINT64_MAX;
  }
};

struct Scratch {
  SurfacePoint* points;  // [kPoints]
  PointGrid grid;
  int32_t* values;  // [kPoints]
  uint32_t* far;    // [kAsked] distance of a mirrored point to the surface

  bool allocate(Arena& arena) {
    points = arena.alloc<SurfacePoint>(kPoints);
    grid.points = points;
    grid.starts = arena.alloc<uint32_t>(kCells * kCells * kCells + 1);
    grid.order = arena.alloc<uint16_t>(kPoints);
    grid.positions = arena.alloc<Vec3i>(kPoints);
    values = arena.alloc<int32_t>(kPoints);
    far = arena.alloc<uint32_t>(kAsked);
    return arena.ok();
  }
};

int32_t coordinate(Vec3i p, int axis) { return axis == 0 ? p.x : p.z; }

// Distance that nine of ten mirrored points keep within, and half the median way that they lack along the axis.
uint32_t mirror_error(const Scratch& s, int axis, int32_t plane, int32_t* lacking) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < kAsked; ++i) {
    Vec3i p = s.points[i * (kPoints / kAsked)].position;
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

struct Plane {
  int32_t at;
  uint32_t error;
};

Plane best_plane(const Scratch& s, int axis, int32_t middle) {
  int64_t sum = 0;
  for (uint32_t i = 0; i < kPoints; ++i) {
    s.values[i] = coordinate(s.points[i].position, axis);
    sum += s.values[i];
  }
  heap_sort(s.values, kPoints, [](int32_t a, int32_t b) { return a < b; });
  const int32_t starts[4] = {middle, 0, s.values[kPoints / 2], static_cast<int32_t>(round_shift(sum, 12))};
  Plane best = {0, UINT32_MAX}, given = {0, UINT32_MAX};
  for (int i = 0; i < 4; ++i) {
    int32_t at = starts[i];
    bool seen = false;
    for (int before = 0; before < i; ++before) seen = seen || starts[before] == at;
    for (int round = 0; round < kRounds && !seen; ++round) {
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

bool find_mirror_frame(const Mesh& mesh, Mirroring mirroring, const int32_t (&middle)[2], Arena& arena,
                       MirrorFrame* frame) {
  const ArenaScope scope(arena);
  Scratch s;
  if (!s.allocate(arena)) return false;
  if (arena.measuring()) return true;
  *frame = MirrorFrame();
  if (mirroring == Mirroring::kNever) return true;
  spread_points(mesh, kPoints, kSeed, s.points);
  s.grid.build();
  const Plane x = best_plane(s, 0, middle[0]);
  frame->plane = x.at;
  frame->error = x.error;
  if (x.error > kRotationError) {
    const Plane z = best_plane(s, 1, middle[1]);
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

}  // namespace sinew
