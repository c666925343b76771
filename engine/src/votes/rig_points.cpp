// SPDX-License-Identifier: MIT
// Features of surface points from marches through the voxels, and their neighbors by plain search.
#include "votes/rig_points.hpp"

#include "core/sort.hpp"
#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

// factor times a length in grid units.
int16_t length_feature(int64_t factor, int64_t value) { return feature(round_shift(factor * value, kToQ13)); }

// A unit vector across n, and one across both; Q14.
void span(Vec3i n, Vec3i* u, Vec3i* w) {
  constexpr int32_t kSteep = 11469;  // 0.7
  const Vec3i axis = abs64(n.x) < kSteep ? Vec3i{1 << 14, 0, 0} : Vec3i{0, 1 << 14, 0};
  *u = unit_vector(cross(n, axis), 14);
  *w = unit_vector(cross(n, *u), 14);
}

constexpr uint32_t kMarches = 9;
constexpr uint32_t kLongestMarch = 4 * kRigCells;  // half cells: twice the longest side

// Median length of the ray straight in and of eight at 30 degrees around it, half cells.
uint32_t thickness(const Interior& interior, Vec3i p, Vec3i normal, uint32_t straight) {
  Vec3i u, w;
  span(normal, &u, &w);
  constexpr int64_t kCos30 = 14189, kSin30 = 8192, kCos45 = 11585;  // Q14
  const int64_t round[8][2] = {{1 << 14, 0},    {kCos45, kCos45},   {0, 1 << 14},    {-kCos45, kCos45},
                               {-(1 << 14), 0}, {-kCos45, -kCos45}, {0, -(1 << 14)}, {kCos45, -kCos45}};
  uint32_t distances[kMarches];
  distances[0] = straight;
  for (uint32_t k = 0; k < 8; ++k) {
    const auto component = [&](int32_t n, int32_t a, int32_t b) {
      return static_cast<int32_t>(round_shift(-kCos30 * n, 14) +
                                  round_shift(kSin30 * (round[k][0] * a + round[k][1] * b), 28));
    };
    distances[k + 1] =
        interior.march(p, {component(normal.x, u.x, w.x), component(normal.y, u.y, w.y), component(normal.z, u.z, w.z)},
                       kLongestMarch);
  }
  heap_sort(distances, kMarches, [](uint32_t a, uint32_t b) { return a < b; });
  return distances[kMarches / 2];
}

struct BodyExtent {
  Vec3i low, high, mean;
  int64_t rms;
};

BodyExtent measure(const SurfacePoint* points) {
  BodyExtent body = {points[0].position, points[0].position, {0, 0, 0}, 0};
  Vec3l sum = {0, 0, 0};
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const Vec3i p = points[i].position;
    grow(p, &body.low, &body.high);
    sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  }
  body.mean = round_div(Vec3l{0, sum.y, sum.z}, kSetPoints);  // on the plane
  int64_t squares = 0;                                        // 512 x 2^45 at most
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const Vec3i d = points[i].position - body.mean;
    squares += dot(d, d);
  }
  body.rms = isqrt64(static_cast<uint64_t>(squares / kSetPoints));
  return body;
}

void describe(const Interior& interior, const BodyExtent& body, SurfacePoint* point, Vec3i* medial, int16_t* row) {
  const int32_t half_cell = interior.grid.cell_size / 2;
  const Vec3i p = point->position;
  Vec3i n = point->normal;
  if (n == Vec3i{0, 0, 0}) n = {0, 1 << 14, 0};
  uint32_t inward = interior.march(p, Vec3i{0, 0, 0} - n, kLongestMarch);
  const uint32_t outward = interior.march(p, n, kLongestMarch);
  if (outward > inward + 4 && inward < 4) {  // more than two cells deeper on the other side: the face looks inward
    n = Vec3i{0, 0, 0} - n;
    inward = outward;
  }
  point->normal = n;
  const uint32_t t = thickness(interior, p, n, inward);  // half cells
  const int64_t back = int64_t{half_cell} * t / 2;       // half the thickness
  const Vec3i m = {p.x - static_cast<int32_t>(round_shift(back * n.x, 14)),
                   p.y - static_cast<int32_t>(round_shift(back * n.y, 14)),
                   p.z - static_cast<int32_t>(round_shift(back * n.z, 14))};
  *medial = m;
  const int32_t sign = PointSet::on_left(*point) ? 1 : -1;
  const auto put3 = [&](uint32_t channel, int64_t factor, Vec3i v) {
    row[channel] = length_feature(factor * sign, v.x);
    row[channel + 1] = length_feature(factor, v.y);
    row[channel + 2] = length_feature(factor, v.z);
  };
  put3(kRigPosition, 2, p);
  row[kRigNormal] = feature(round_shift(int64_t{sign} * n.x, 1));
  row[kRigNormal + 1] = feature(round_shift(n.y, 1));
  row[kRigNormal + 2] = feature(round_shift(n.z, 1));
  put3(kRigMedial, 2, m);
  row[kRigThickness] = length_feature(4, int64_t{half_cell} * t);
  const uint32_t cell = interior.grid.cell_of(m);
  row[kRigDepth] = length_feature(8, int64_t{interior.depth[cell]} * interior.grid.cell_size / kDepthUnits);
  constexpr int32_t kOne = 1 << 14;
  const Vec3i axes[6] = {{sign * kOne, 0, 0}, {-sign * kOne, 0, 0}, {0, kOne, 0},
                         {0, -kOne, 0},       {0, 0, kOne},         {0, 0, -kOne}};
  for (uint32_t i = 0; i < 6; ++i) {
    row[kRigExtents + i] = length_feature(4, int64_t{half_cell} * interior.march(m, axes[i], kRigCells));
  }
  const uint16_t distance = interior.distance[interior.grid.cell_of(p)];
  row[kRigDistance] = length_feature(1, int64_t{distance} * interior.grid.cell_size / kDistanceUnits);
  const Vec3i away = p - body.mean;
  const int64_t spread = 2 * (body.rms > 256 ? body.rms : 256);
  row[kRigRelative] = feature(round_div(int64_t{sign} * away.x * 8192, spread));
  row[kRigRelative + 1] = feature(round_div(int64_t{away.y} * 8192, spread));
  row[kRigRelative + 2] = feature(round_div(int64_t{away.z} * 8192, spread));
  const int64_t sizes[6] = {
      body.high.x - body.low.x, body.high.y - body.low.y, body.high.z - body.low.z, body.rms, body.mean.y, body.mean.z};
  for (uint32_t i = 0; i < 6; ++i) row[kRigBody + i] = feature(round_shift(3 * sizes[i], kToQ13 + 1));
}

// The `count` smallest keys, in order, in front; what was there besides is lost. A heap of them whose largest is on top.
void smallest_first(uint64_t* keys, uint32_t size, uint32_t count) {
  const auto sift = [&](uint32_t root) {
    const uint64_t key = keys[root];
    for (uint32_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
      if (child + 1 < count && keys[child] < keys[child + 1]) ++child;
      if (keys[child] <= key) break;
      keys[root] = keys[child];
      root = child;
    }
    keys[root] = key;
  };
  for (uint32_t root = count / 2; root-- > 0;) sift(root);
  for (uint32_t i = count; i < size; ++i) {
    if (keys[i] >= keys[0]) continue;
    keys[0] = keys[i];
    sift(0);
  }
  heap_sort(keys, count, [](uint64_t a, uint64_t b) { return a < b; });
}

void find_neighbors(PointSet* set, uint64_t* keys) {
  constexpr int kIndexBits = 9;  // of kSetPoints
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    for (uint32_t j = 0; j < kSetPoints; ++j) {
      const Vec3i a = set->points[i].position - set->points[j].position, b = set->medial[i] - set->medial[j];
      keys[j] = (static_cast<uint64_t>(dot(a, a) + dot(b, b)) << kIndexBits) | j;
    }
    keys[i] = i;  // itself
    smallest_first(keys, kSetPoints, kNeighbors * kFarStep + 1);
    for (uint32_t k = 0; k < kNeighbors; ++k) {
      set->near_neighbors[i * kNeighbors + k] = static_cast<uint32_t>(keys[k + 1]) & (kSetPoints - 1);
      set->far_neighbors[i * kNeighbors + k] = static_cast<uint32_t>(keys[(k + 1) * kFarStep]) & (kSetPoints - 1);
    }
  }
}

}  // namespace

bool PointSet::allocate(Arena& arena) {
  points = arena.alloc<SurfacePoint>(kSetPoints);
  medial = arena.alloc<Vec3i>(kSetPoints);
  features = arena.alloc<int16_t>(kSetPoints * kRigChannels);
  near_neighbors = arena.alloc<uint32_t>(kSetPoints * kNeighbors);
  far_neighbors = arena.alloc<uint32_t>(kSetPoints * kNeighbors);
  return arena.ok();
}

bool make_point_set(const Mesh& mesh, const Interior& interior, uint64_t seed, Arena& arena, PointSet* set) {
  const ArenaScope scope(arena);
  uint64_t* const keys = arena.alloc<uint64_t>(kSetPoints);
  if (!arena.ok()) return false;
  if (arena.measuring()) return true;
  spread_points(mesh, kSetPoints, seed, set->points);
  const BodyExtent body = measure(set->points);
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    describe(interior, body, &set->points[i], &set->medial[i], set->features + size_t{i} * kRigChannels);
  }
  find_neighbors(set, keys);
  return true;
}

}  // namespace sinew::rigging
