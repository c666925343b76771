// SPDX-License-Identifier: MIT
// Stratified sampling by area in integers: one walk over the triangles.
#include "front/surface_points.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

// Knuth's MMIX generator; its high bits are good.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 0xD1B54A32D192ED03u) {
    (void)next();
    (void)next();
  }
  uint32_t next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<uint32_t>(state_ >> 32);
  }

 private:
  uint64_t state_;
};

// Twice the area in grid units; below 2^42.
uint64_t doubled_area(const Mesh& mesh, uint32_t triangle) {
  const uint32_t* const t = mesh.triangles + size_t{3} * triangle;
  const Vec3i a = mesh.positions[t[0]];
  return length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
}

void put_inside(const Mesh& mesh, uint32_t triangle, Random* random, SurfacePoint* point) {
  const uint32_t* const t = mesh.triangles + size_t{3} * triangle;
  // Uniform on the triangle: sqrt(u) from the first corner to the other side, then v along it.
  const uint32_t away = isqrt64(static_cast<uint64_t>(random->next()) << 30) >> 16;  // Q15
  const uint32_t along = random->next() >> 17;                                       // Q15
  const uint32_t third = static_cast<uint32_t>(round_shift(static_cast<int64_t>(away) * along, 15));
  point->triangle = triangle;
  point->share[0] = static_cast<uint16_t>(32768 - away);
  point->share[1] = static_cast<uint16_t>(away - third);
  point->share[2] = static_cast<uint16_t>(third);
  Vec3l sum = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const Vec3i p = mesh.positions[t[i]];
    point->corner[i] = t[i];
    sum = {sum.x + int64_t{p.x} * point->share[i], sum.y + int64_t{p.y} * point->share[i],
           sum.z + int64_t{p.z} * point->share[i]};
  }
  point->position = {static_cast<int32_t>(round_shift(sum.x, 15)), static_cast<int32_t>(round_shift(sum.y, 15)),
                     static_cast<int32_t>(round_shift(sum.z, 15))};
  const Vec3i a = mesh.positions[t[0]];
  point->normal = unit_vector(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a), kNormalBits);
}

}  // namespace

void spread_points(const Mesh& mesh, uint32_t count, uint64_t seed, SurfacePoint* points) {
  uint64_t total = 0;  // below 2^42 x 2^25 triangles is too much for 64 bits: eight bits go where there are many
  const int drop = mesh.triangle_count > (1u << 20) ? 8 : 0;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) total += doubled_area(mesh, t) >> drop;
  Random random(seed);
  if (total == 0) {
    for (uint32_t i = 0; i < count; ++i) {
      const uint64_t pick = (static_cast<uint64_t>(i) << 32) + random.next();
      const uint32_t v = static_cast<uint32_t>(mul_shift(static_cast<int64_t>(pick / count), mesh.welded_count, 32));
      points[i] = {mesh.positions[v], {0, 0, 0}, kNoTriangle, {v, v, v}, {32768, 0, 0}};
    }
    return;
  }
  uint64_t before = 0;  // area of the triangles in front of `triangle`
  uint32_t triangle = 0;
  uint64_t area = doubled_area(mesh, 0) >> drop;
  for (uint32_t i = 0; i < count; ++i) {
    const uint64_t pick = ((static_cast<uint64_t>(i) << 32) + random.next()) / count;  // Q32 of the whole
    const uint64_t target =
        static_cast<uint64_t>(mul_shift(static_cast<int64_t>(total), static_cast<int64_t>(pick), 32));
    while (before + area <= target && triangle + 1 < mesh.triangle_count) {
      before += area;
      area = doubled_area(mesh, ++triangle) >> drop;
    }
    put_inside(mesh, triangle, &random, &points[i]);
  }
}

bool is_sheet(const SurfacePoint* points, uint32_t count) {
  uint64_t squares[3] = {0, 0, 0};  // Q10 after the shift; with 2^12 points below 2^22, and their products below 2^44
  int64_t products[3] = {0, 0, 0};
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3l n = {points[i].normal.x, points[i].normal.y, points[i].normal.z};
    squares[0] += static_cast<uint64_t>(n.x * n.x);
    squares[1] += static_cast<uint64_t>(n.y * n.y);
    squares[2] += static_cast<uint64_t>(n.z * n.z);
    products[0] += n.x * n.y;
    products[1] += n.y * n.z;
    products[2] += n.z * n.x;
  }
  constexpr int kDrop = 2 * kNormalBits - 10;
  uint64_t whole = 0, sum = 0;
  for (int k = 0; k < 3; ++k) {
    const uint64_t own = squares[k] >> kDrop;
    const int64_t mixed = round_shift(products[k], kDrop);
    whole += own;
    sum += own * own + 2 * static_cast<uint64_t>(mixed * mixed);
  }
  return whole > 0 && sum * 5 > whole * whole * 4;
}

}  // namespace sinew::rigging
