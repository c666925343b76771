// SPDX-License-Identifier: MIT
// Exact integer visibility of bones from vertices (stage 4): box tree over the triangles, front-face crossing test.
#include "heat/visibility.hpp"

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

int64_t dot64(Vec3l n, Vec3i d) { return n.x * d.x + n.y * d.y + n.z * d.z; }

int32_t abs32(int32_t v) { return v < 0 ? -v : v; }

// Segment against box by separating axes, everything doubled to stay in integers: `middle` = start + target,
// `half` = |target - start|, `along` = target - start.
bool segment_meets_box(Vec3i middle, Vec3i along, Vec3i half, Vec3i low, Vec3i high) {
  const Vec3i m = middle - (low + high);
  const Vec3i e = high - low;
  if (abs32(m.x) > e.x + half.x || abs32(m.y) > e.y + half.y || abs32(m.z) > e.z + half.z) return false;
  const Vec3l c = cross(m, along);
  return abs64(c.x) <= static_cast<int64_t>(e.y) * half.z + static_cast<int64_t>(e.z) * half.y &&
         abs64(c.y) <= static_cast<int64_t>(e.z) * half.x + static_cast<int64_t>(e.x) * half.z &&
         abs64(c.z) <= static_cast<int64_t>(e.x) * half.y + static_cast<int64_t>(e.y) * half.x;
}

void grow(Vec3i* low, Vec3i* high, Vec3i p) {
  if (p.x < low->x) low->x = p.x;
  if (p.y < low->y) low->y = p.y;
  if (p.z < low->z) low->z = p.z;
  if (p.x > high->x) high->x = p.x;
  if (p.y > high->y) high->y = p.y;
  if (p.z > high->z) high->z = p.z;
}

uint32_t leaf_span_for(uint32_t triangles) {
  uint32_t span = 1;
  while (span < (triangles + FaceTree::kLeafFaces - 1) / FaceTree::kLeafFaces) span *= 2;
  return span;
}

}  // namespace

bool crosses_front_wide(Vec3i start, Vec3i target, Vec3i a, Vec3i b, Vec3i c) {
  const Vec3i d = target - start;
  const Vec3i ra = a - start, rb = b - start, rc = c - start;
  const Vec3l normal = cross(b - a, c - a);
  const int64_t depth = dot64(normal, ra);
  if (depth >= 0) return false;  // start is behind the face or in its plane
  const Wide speed = wide_dot(normal, d);
  const Wide reach = {depth >> 32, static_cast<uint64_t>(depth) & 0xFFFFFFFFu};
  if (!less(speed, reach)) return false;  // depth / speed must be below 1 (both are negative)
  return !positive(wide_dot(cross(ra, rb), d)) && !positive(wide_dot(cross(rb, rc), d)) &&
         !positive(wide_dot(cross(rc, ra), d));
}

bool crosses_front(Vec3i start, Vec3i target, Vec3i a, Vec3i b, Vec3i c) {
  const Vec3i d = target - start;
  // Mesh points differ by at most 2^20 per axis, so cross products stay below 2^41 and the determinants below 3 * 2^61.
  if (abs32(d.x) > kSide || abs32(d.y) > kSide || abs32(d.z) > kSide) {
    return crosses_front_wide(start, target, a, b, c);
  }
  const Vec3l normal = cross(b - a, c - a);
  const Vec3i ra = a - start;
  const int64_t depth = dot64(normal, ra);
  if (depth >= 0) return false;
  if (dot64(normal, d) >= depth) return false;
  const Vec3i rb = b - start, rc = c - start;
  return dot64(cross(ra, rb), d) <= 0 && dot64(cross(rb, rc), d) <= 0 && dot64(cross(rc, ra), d) <= 0;
}

bool FaceTree::allocate(Arena& arena, const Counts& counts) {
  const size_t nodes = 2 * static_cast<size_t>(leaf_span_for(counts.triangles()));
  order = arena.alloc<uint32_t>(counts.triangles());
  component_first = arena.alloc<uint32_t>(static_cast<size_t>(counts.vertices) + 1);
  box_low = arena.alloc<Vec3i>(nodes);
  box_high = arena.alloc<Vec3i>(nodes);
  return arena.ok();
}

void FaceTree::build(const Mesh& mesh) {
  for (uint32_t c = 0; c <= mesh.component_count; ++c) component_first[c] = 0;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) ++component_first[mesh.component[mesh.triangles[3 * t]] + 1];
  for (uint32_t c = 0; c < mesh.component_count; ++c) component_first[c + 1] += component_first[c];
  for (uint32_t t = 0; t < mesh.triangle_count; ++t)
    order[component_first[mesh.component[mesh.triangles[3 * t]]]++] = t;
  for (uint32_t c = mesh.component_count; c > 0; --c) component_first[c] = component_first[c - 1];
  component_first[0] = 0;

  leaf_span = leaf_span_for(mesh.triangle_count);
  leaf_count = (mesh.triangle_count + kLeafFaces - 1) / kLeafFaces;
  for (uint32_t leaf = 0; leaf < leaf_count; ++leaf) {
    const uint32_t first = leaf * kLeafFaces;
    Vec3i low = mesh.positions[mesh.triangles[3 * order[first]]];
    Vec3i high = low;
    for (uint32_t place = first; place < mesh.triangle_count && place < first + kLeafFaces; ++place) {
      for (uint32_t k = 0; k < 3; ++k) grow(&low, &high, mesh.positions[mesh.triangles[3 * order[place] + k]]);
    }
    box_low[leaf_span + leaf] = low;
    box_high[leaf_span + leaf] = high;
  }
  // Nodes whose leaves all lie past leaf_count stay unset; the walk skips them by their range.
  uint32_t used = leaf_count;
  for (uint32_t level = leaf_span / 2; level > 0; level /= 2) {
    const uint32_t used_below = used;
    used = (used + 1) / 2;
    for (uint32_t i = 0; i < used; ++i) {
      const uint32_t left = 2 * (level + i);
      box_low[level + i] = box_low[left];
      box_high[level + i] = box_high[left];
      if (2 * i + 1 < used_below) {
        grow(&box_low[level + i], &box_high[level + i], box_low[left + 1]);
        grow(&box_low[level + i], &box_high[level + i], box_high[left + 1]);
      }
    }
  }
}

bool FaceTree::hidden(const Mesh& mesh, uint32_t vertex, Vec3i target, uint32_t first, uint32_t last, bool outside,
                      uint32_t* hint) const {
  const Vec3i start = mesh.positions[vertex];
  const Vec3i along = target - start;
  if (leaf_count == 0 || (along.x == 0 && along.y == 0 && along.z == 0)) return false;
  const Vec3i half = {abs32(along.x), abs32(along.y), abs32(along.z)};
  const Vec3i middle = start + target;

  const auto hides = [&](uint32_t place) {
    if ((place >= first && place < last) == outside) return false;
    const uint32_t* t = mesh.triangles + 3 * static_cast<size_t>(order[place]);
    if (t[0] == vertex || t[1] == vertex || t[2] == vertex) return false;
    return crosses_front(start, target, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
  };
  if (*hint != kNoFace && hides(*hint)) return true;

  struct Entry {
    uint32_t node, first_leaf, span;
  };
  Entry stack[34];  // one sibling per level, at most 32 levels
  uint32_t depth = 0;
  stack[depth++] = {1, 0, leaf_span};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.first_leaf >= leaf_count) continue;
    const uint32_t place_begin = entry.first_leaf * kLeafFaces;
    const uint32_t place_end = place_begin + entry.span * kLeafFaces;
    if (outside ? (place_begin >= first && place_end <= last) : (place_end <= first || place_begin >= last)) continue;
    if (!segment_meets_box(middle, along, half, box_low[entry.node], box_high[entry.node])) continue;
    if (entry.span > 1) {
      const uint32_t span = entry.span / 2;
      stack[depth++] = {2 * entry.node + 1, entry.first_leaf + span, span};
      stack[depth++] = {2 * entry.node, entry.first_leaf, span};
      continue;
    }
    for (uint32_t place = place_begin; place < place_end && place < mesh.triangle_count; ++place) {
      if (hides(place)) {
        *hint = place;
        return true;
      }
    }
  }
  return false;
}

}  // namespace sinew
