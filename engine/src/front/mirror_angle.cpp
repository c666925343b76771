// SPDX-License-Identifier: MIT
// Mirrored points are matched with the nearest ones, and the plane between the two is taken next.
#include "front/mirror_angle.hpp"

#include "core/sort.hpp"
#include "core/vector_math.hpp"
#include "front/mirror_frame.hpp"
#include "front/point_grid.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kAskedPoints = 512;
constexpr uint32_t kAngles = 8, kPointRounds = 6, kVertexRounds = 5, kMostVertices = 1u << 15, kAskedVertices = 2048;
// Cost of a plane across the expected front relative to one along it.
constexpr int64_t kTurnCost = kSide / 50;
// Tenths of the mirrored points that have to be near: of a mirrored mesh, then of a posed one.
constexpr uint32_t kShares[2] = {9, 6};
constexpr int64_t kNearFront = (1 << 28) * 2 / 3;  // sine of 42 degrees
constexpr int32_t kVertexReach = kSide / 40;  // two vertices are each other's image when nearer; half of it each round
// The surface's axis is clear from this length on; a plane is beside it within this sine, of 6 degrees, and stays good there.
constexpr int64_t kClearAxis = 30, kBesideAxis = (1 << 28) / 10;
constexpr uint32_t kAxisLoss = kSide / 300;

struct Plane {
  Heading normal = {1 << 28, 0};
  int64_t at = 0;  // along the normal, grid units
  uint32_t error = UINT32_MAX;
};

struct AngleScratch {
  SurfacePoint* points;
  Vec3i* upright;  // [kMirrorPoints]
  PointGrid grid, vertices;
  uint32_t* far;  // [kAskedPoints]

  bool allocate(Arena& arena) {
    points = arena.alloc<SurfacePoint>(kMirrorPoints);
    upright = arena.alloc<Vec3i>(kMirrorPoints);
    (void)grid.allocate(arena, kMirrorPoints);
    (void)vertices.allocate(arena, kMostVertices);
    far = arena.alloc<uint32_t>(kAskedPoints);
    return arena.ok();
  }
};

Vec3i turned_up(Vec3i p, uint32_t up_axis) { return up_axis == 0 ? p : Vec3i{p.x, p.z, -p.y}; }

int64_t along(Heading n, int64_t x, int64_t z) { return round_shift(n.x * x + n.z * z, 28); }

Vec3i mirrored(const Plane& plane, Vec3i p) {
  const int64_t twice = 2 * (along(plane.normal, p.x, p.z) - plane.at);
  return {p.x - static_cast<int32_t>(round_shift(twice * plane.normal.x, 28)), p.y,
          p.z - static_cast<int32_t>(round_shift(twice * plane.normal.z, 28))};
}

// Second moments of what lies between matched points, and the middles between them.
struct Matches {
  int64_t xx = 0, xz = 0, zz = 0, middle_x = 0, middle_z = 0;
  uint32_t count = 0;

  void add(Vec3i a, Vec3i b) {
    const int64_t dx = int64_t{a.x} - b.x, dz = int64_t{a.z} - b.z;  // below 2^21, of at most 2^15 points
    xx += dx * dx;
    xz += dx * dz;
    zz += dz * dz;
    middle_x += int64_t{a.x} + b.x;
    middle_z += int64_t{a.z} + b.z;
    ++count;
  }
  // The plane that they lie across.
  void fit(Plane* plane) const {
    const Vec3l doubled = {xx - zz, 2 * xz, 0};
    if (count == 0 || (doubled.x == 0 && doubled.y == 0)) return;
    // The direction of half the angle is the sum of the doubled direction and the axis, whichever does not cancel.
    const Vec3i unit = unit_vector(doubled, 28);
    constexpr int64_t kOne = 1 << 28;
    const Vec3l half = unit.x >= 0 ? Vec3l{kOne + unit.x, unit.y, 0} : Vec3l{unit.y, kOne - unit.x, 0};
    const Vec3i normal = unit_vector(half, 28);
    plane->normal = {normal.x, normal.y};
    const int64_t size = 2 * int64_t{count};
    plane->at = along(plane->normal, round_div(middle_x, size), round_div(middle_z, size));
  }
};

// Measures a plane by the distance that so many tenths of the mirrored points keep within, and moves it between the points that
// it mirrors.
void match(const AngleScratch& s, uint32_t tenths, Plane* plane) {
  Matches matches;
  for (uint32_t i = 0; i < kAskedPoints; ++i) {
    const Vec3i p = s.upright[i * (kMirrorPoints / kAskedPoints)];
    uint32_t near = 0;
    uint64_t squared = 0;
    s.far[i] = kSide / 8;
    if (!s.grid.nearest(mirrored(*plane, p), &near, &squared)) continue;
    s.far[i] = isqrt64(squared);
    if (s.far[i] < kSide / 16) matches.add(p, s.upright[near]);
  }
  heap_sort(s.far, kAskedPoints, [](uint32_t a, uint32_t b) { return a < b; });
  plane->error = s.far[kAskedPoints * tenths / 10];
  matches.fit(plane);
}

// The better of the measured angles.
Plane refined(const AngleScratch& s, uint32_t tenths, Plane start) {
  Plane best;
  for (uint32_t round = 0; round <= kPointRounds; ++round) {
    const Plane before = start;
    match(s, tenths, &start);
    if (start.error < best.error) best = {before.normal, before.at, start.error};
  }
  return best;
}

// By vertices that mirror each other.
void match_vertices(const AngleScratch& s, const Mesh& mesh, uint32_t up_axis, Plane* plane) {
  const uint32_t step = s.vertices.count / kAskedVertices + 1;
  for (uint32_t round = 0; round < kVertexRounds; ++round) {
    Matches matches;
    uint32_t asked = 0;
    for (uint32_t i = 0; i < s.vertices.count; i += step, ++asked) {
      const Vec3i p = s.vertices.positions[i];
      uint32_t near = 0;
      uint64_t squared = 0;
      if (s.vertices.nearest(mirrored(*plane, p), &near, &squared) &&
          squared < uint64_t{kVertexReach} * uint64_t{kVertexReach} >> (2 * round)) {
        matches.add(p, turned_up(mesh.positions[near], up_axis));
      }
    }
    if (matches.count < asked / 2) return;
    matches.fit(plane);
  }
}

}  // namespace

SurfaceAxis surface_axis(const Mesh& mesh, uint32_t up_axis) {
  uint64_t total = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) total += mesh.areas[v] >> 8;
  const int top = top_bit(total) - 29, shift = top > 0 ? top : 0;
  // Weights below 2^30 in all, positions below 2^16 from their mean.
  const auto weight = [&](uint32_t v) { return static_cast<int64_t>((mesh.areas[v] >> 8) >> shift); };
  const auto position = [&](uint32_t v) {
    const Vec3i p = turned_up(mesh.positions[v], up_axis);
    return Heading{round_shift(p.x, 5), round_shift(p.z, 5)};
  };
  int64_t weights = 1, x = 0, z = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    weights += weight(v);
    x += weight(v) * position(v).x;
    z += weight(v) * position(v).z;
  }
  x = round_div(x, weights);
  z = round_div(z, weights);
  int64_t xx = 0, xz = 0, zz = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const int64_t dx = position(v).x - x, dz = position(v).z - z;
    xx += weight(v) * dx * dx;
    xz += weight(v) * dx * dz;
    zz += weight(v) * dz * dz;
  }
  xx >>= 2;
  xz >>= 2;
  zz >>= 2;
  const Heading doubled = unit_heading(xx - zz, 2 * xz);
  constexpr int64_t kOne = 1 << 28;
  if (doubled.x == 0 && doubled.z == 0) return {{kOne, 0}, 0};
  const int64_t size = static_cast<int64_t>(length(Vec3l{xx - zz, 2 * xz, 0}));
  const int64_t along = (size >> 12) * 1024 / (((xx + zz) >> 12) + 1);
  return {doubled.x >= 0 ? unit_heading(kOne + doubled.x, doubled.z) : unit_heading(doubled.z, kOne - doubled.x),
          along};
}

bool find_mirror_angle(const Mesh& mesh, uint32_t up_axis, Heading expected, Arena& arena, Heading* normal,
                       bool* found) {
  const ArenaScope scope(arena);
  AngleScratch s;
  if (!s.allocate(arena)) return false;
  *found = false;
  if (arena.measuring()) return true;
  spread_points(mesh, kMirrorPoints, kMirrorSeed, s.points);
  int64_t x = 0, z = 0;
  for (uint32_t i = 0; i < kMirrorPoints; ++i) {
    s.upright[i] = turned_up(s.points[i].position, up_axis);
    x += s.upright[i].x;
    z += s.upright[i].z;
  }
  s.grid.build(kMirrorPoints, [&](uint32_t i) { return s.upright[i]; });
  const auto plane_across = [&](Heading side) {
    Plane plane;
    plane.normal = side;
    plane.at = along(side, round_div(x, kMirrorPoints), round_div(z, kMirrorPoints));
    return plane;
  };
  // Eighths of 180 degrees: cosines and sines, Q28.
  constexpr int64_t kTable[kAngles][2] = {{268435456, 0},          {248002075, 102725825}, {189812531, 189812531},
                                          {102725825, 248002075},  {0, 268435456},         {-102725825, 248002075},
                                          {-189812531, 189812531}, {-248002075, 102725825}};
  const SurfaceAxis axis = surface_axis(mesh, up_axis);
  Plane best;
  int64_t least = 0;
  // Most of a mesh that is symmetric but for its pose is still symmetric: then a plane near the expected front is
  // accepted.
  for (const uint32_t tenths : kShares) {
    if (tenths != kShares[0] && expected.x == 0 && expected.z == 0) return true;
    for (const auto& angle : kTable) {  // from the axis, so that the same mesh is asked alike in every position
      const Heading start = {round_shift(axis.along.x * angle[0] - axis.along.z * angle[1], 28),
                             round_shift(axis.along.x * angle[1] + axis.along.z * angle[0], 28)};
      const Plane plane = refined(s, tenths, plane_across(start));
      const int64_t across = abs64(round_shift(plane.normal.x * expected.x + plane.normal.z * expected.z, 28));  // Q28
      const bool most = tenths != kShares[0];
      const int64_t cost = plane.error + round_shift(across * kTurnCost, 28);
      if (plane.error >= kFoldError || (most && across > kNearFront) || (*found && cost >= least)) continue;
      *found = true;
      least = cost;
      best = plane;
    }
    if (*found && tenths != kShares[0]) {
      *normal = best.normal;
      return true;
    }
    if (*found) break;
  }
  if (!*found) return true;
  const Heading sides[2] = {axis.along, {-axis.along.z, axis.along.x}};
  for (const Heading& side : sides) {
    if (axis.length < kClearAxis ||
        abs64(round_shift(side.x * best.normal.z - side.z * best.normal.x, 28)) > kBesideAxis)
      continue;
    Plane moved = plane_across(side);
    match(s, kShares[0], &moved);
    if (moved.error > best.error + kAxisLoss) continue;
    *normal = side;
    return true;
  }
  if (mesh.welded_count <= kMostVertices) {
    s.vertices.build(mesh.welded_count, [&](uint32_t i) { return turned_up(mesh.positions[i], up_axis); });
    match_vertices(s, mesh, up_axis, &best);
  }
  *normal = best.normal;
  return true;
}

}  // namespace sinew::rigging
