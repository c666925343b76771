// SPDX-License-Identifier: MIT
// Exact integer visibility of bones from vertices (stage 4): box tree over the triangles, front-face crossing test.
#include "heat/visibility.hpp"

#include "core/build.hpp"

namespace sinew {
namespace {

// Sums of 64 x 32-bit products, exact: value = high * 2^32 + low.
struct Wide {
  int64_t high;
  uint64_t low;  // < 2^32
};

// |n| < 2^43 and |d| < 2^25, so each product is below 2^68.
Wide wide_dot(Vec3l n, Vec3i d) {
  const int64_t terms[3][2] = {{n.x, d.x}, {n.y, d.y}, {n.z, d.z}};
  Wide sum{0, 0};
  for (const auto& term : terms) {
    sum.high += mul_shift(term[0], term[1], 32);
    sum.low += (static_cast<uint64_t>(term[0]) * static_cast<uint64_t>(term[1])) & 0xFFFFFFFFu;
  }
  sum.high += static_cast<int64_t>(sum.low >> 32);
  sum.low &= 0xFFFFFFFFu;
  return sum;
}

bool positive(Wide v) { return v.high > 0 || (v.high == 0 && v.low != 0); }
bool less(Wide a, Wide b) { return a.high != b.high ? a.high < b.high : a.low < b.low; }

SINEW_ONCE int64_t determinant(Vec3i a, Vec3i b, Vec3i c) { return dot(cross(a, b), c); }

int32_t abs32(int32_t v) { return v < 0 ? -v : v; }

constexpr int32_t kNowhere = 1 << 28;  // targets lie within 2^23

void grow(BoxGroup* group, uint32_t slot, Vec3i low, Vec3i high) {
  const int32_t lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (lows[axis] < group->low[axis][slot]) group->low[axis][slot] = lows[axis];
    if (highs[axis] > group->high[axis][slot]) group->high[axis][slot] = highs[axis];
  }
}

// Groups of all levels over this many triangles.
uint32_t group_count(uint32_t triangles) {
  uint32_t boxes = triangles, groups = 0;
  do {
    boxes = (boxes + kBoxesInGroup - 1) / kBoxesInGroup;
    groups += boxes;
  } while (boxes > 1);
  return groups;
}

}  // namespace

bool crosses_front_wide(Vec3i start, Vec3i target, Vec3i a, Vec3i b, Vec3i c) {
  const Vec3i d = target - start;
  const Vec3i ra = a - start, rb = b - start, rc = c - start;
  const Vec3l normal = cross(b - a, c - a);
  const int64_t depth = dot(normal, ra);
  if (depth >= 0) return false;  // start is behind the face or in its plane
  const Wide speed = wide_dot(normal, d);
  const Wide reach = {depth >> 32, static_cast<uint64_t>(depth) & 0xFFFFFFFFu};
  if (!less(speed, reach)) return false;  // depth / speed must be below 1 (both are negative)
  return !positive(wide_dot(cross(ra, rb), d)) && !positive(wide_dot(cross(rb, rc), d)) &&
         !positive(wide_dot(cross(rc, ra), d));
}

bool crosses_front(Vec3i start, Vec3i target, Vec3i a, Vec3i b, Vec3i c) {
  const Vec3i d = target - start;
  // Small builds have only the path that always works: it costs 0.04 % of a bind and is 380 bytes less.
  // Mesh points differ by at most 2^20 per axis, so cross products stay below 2^41 and the determinants below 3 * 2^61.
  if (kSmallCode || abs32(d.x) > kSide || abs32(d.y) > kSide || abs32(d.z) > kSide) {
    return crosses_front_wide(start, target, a, b, c);
  }
  const Vec3l normal = cross(b - a, c - a);
  const Vec3i ra = a - start;
  const int64_t depth = dot(normal, ra);
  if (depth >= 0) return false;
  if (dot(normal, d) >= depth) return false;
  const Vec3i rb = b - start, rc = c - start;
  return determinant(ra, rb, d) <= 0 && determinant(rb, rc, d) <= 0 && determinant(rc, ra, d) <= 0;
}

bool FaceTree::allocate(Arena& arena, const Counts& counts) {
  order = arena.alloc<uint32_t>(counts.triangles());
  part_first = arena.alloc<uint32_t>(static_cast<size_t>(counts.vertices) + 1);
  groups = arena.alloc<BoxGroup>(group_count(counts.triangles()));
  return arena.ok();
}

void FaceTree::build(const Mesh& mesh) {
  for (uint32_t c = 0; c <= mesh.part_count; ++c) part_first[c] = 0;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) ++part_first[mesh.part[mesh.triangles[3 * t]] + 1];
  for (uint32_t c = 0; c < mesh.part_count; ++c) part_first[c + 1] += part_first[c];
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) order[part_first[mesh.part[mesh.triangles[3 * t]]]++] = t;
  for (uint32_t c = mesh.part_count; c > 0; --c) part_first[c] = part_first[c - 1];
  part_first[0] = 0;

  levels = 0;
  if (mesh.triangle_count == 0) return;
  uint32_t boxes = mesh.triangle_count, next = 0;
  do {
    const uint32_t count = (boxes + kBoxesInGroup - 1) / kBoxesInGroup;
    level_first[levels] = next;
    for (uint32_t g = 0; g < count; ++g) {
      BoxGroup& group = groups[next + g];
      for (uint32_t i = 0; i < kBoxesInGroup; ++i) {
        for (int axis = 0; axis < 3; ++axis) {  // boxes that are not there meet nothing
          group.low[axis][i] = kNowhere;
          group.high[axis][i] = -kNowhere;
        }
        const uint32_t box = g * kBoxesInGroup + i;
        if (box >= boxes) continue;
        if (levels > 0) {
          const BoxGroup& below = groups[level_first[levels - 1] + box];
          for (uint32_t k = 0; k < kBoxesInGroup; ++k) {
            grow(&group, i, {below.low[0][k], below.low[1][k], below.low[2][k]},
                 {below.high[0][k], below.high[1][k], below.high[2][k]});
          }
          continue;
        }
        for (uint32_t k = 0; k < 3; ++k) {
          const Vec3i p = mesh.positions[mesh.triangles[3 * order[box] + k]];
          grow(&group, i, p, p);
        }
      }
    }
    next += count;
    boxes = count;
    ++levels;
  } while (boxes > 1);
}

bool FaceTree::hidden(const Mesh& mesh, uint32_t vertex, Vec3i target, uint32_t first, uint32_t last, bool outside,
                      uint32_t* hint) const {
  const Vec3i start = mesh.positions[vertex];
  const Vec3i along = target - start;
  if (levels == 0 || (along.x == 0 && along.y == 0 && along.z == 0)) return false;
  if (outside && last - first == mesh.triangle_count) return false;
  const BoxSegment segment = {{start.x + target.x, start.y + target.y, start.z + target.z},
                              {along.x, along.y, along.z},
                              {abs32(along.x), abs32(along.y), abs32(along.z)}};

  const auto hides = [&](uint32_t position) {
    if ((position >= first && position < last) == outside) return false;
    const uint32_t* t = mesh.triangles + 3 * static_cast<size_t>(order[position]);
    if (t[0] == vertex || t[1] == vertex || t[2] == vertex) return false;
    return crosses_front(start, target, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
  };
  const auto group_hides = [&](uint32_t group) {
    for (uint32_t met = boxes_met(groups[group], segment); met != 0; met &= met - 1) {
      if (!hides(group * kBoxesInGroup + static_cast<uint32_t>(low_bit(met)))) continue;
      *hint = group;
      return true;
    }
    return false;
  };
  const uint32_t looked_at = *hint;
  if (looked_at != kNoGroup && group_hides(looked_at)) return true;

  struct Entry {
    uint32_t level, group, span;  // span: slots under one of the group's boxes
  };
  Entry stack[kMostLevels * kBoxesInGroup];
  uint32_t depth = 0;
  uint32_t top_span = 1;  // below 16 times the triangles
  for (uint32_t level = 1; level < levels; ++level) top_span *= kBoxesInGroup;
  stack[depth++] = {levels - 1, 0, top_span};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.level == 0) {
      if (entry.group != looked_at && group_hides(entry.group)) return true;
      continue;
    }
    const BoxGroup& group = groups[level_first[entry.level] + entry.group];
    for (uint32_t met = boxes_met(group, segment); met != 0; met &= met - 1) {
      const uint32_t box = entry.group * kBoxesInGroup + static_cast<uint32_t>(low_bit(met));
      const uint32_t begin = box * entry.span, end = begin + entry.span;
      if (outside ? begin >= first && end <= last : end <= first || begin >= last) continue;
      stack[depth++] = {entry.level - 1, box, entry.span / kBoxesInGroup};
    }
  }
  return false;
}

}  // namespace sinew
