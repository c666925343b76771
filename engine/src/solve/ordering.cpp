// SPDX-License-Identifier: MIT
// Geometric nested dissection on integer coordinates, without recursion.
#include "solve/ordering.hpp"

#include <string.h>

#include "core/sort.hpp"

namespace sinew {
namespace {

constexpr uint32_t kLeastSamples = 23;
constexpr uint32_t kMostSamples = 255;  // of a region, for its median
constexpr uint32_t kSideBits = 3;       // of a mark: the low side of the cut along each axis

int32_t coordinate(Vec3i p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

struct VertexRange {
  uint32_t begin, end;
};

// A cut of a region: vertices with coordinate <= value on one side.
struct Cut {
  int axis = 0;
  int32_t value = 0;
  uint32_t low_count = 0;
  uint32_t low_border = 0, high_border = 0;  // vertices with a neighbor on the other side
  uint32_t separator() const { return low_border <= high_border ? low_border : high_border; }
};

class Dissection {
 public:
  Dissection(const Mesh& mesh, Ordering& out) : mesh_(mesh), out_(out) {}

  void find_box(VertexRange region, Vec3i* low, Vec3i* high) const {
    *low = *high = mesh_.positions[out_.order[region.begin]];
    for (uint32_t i = region.begin + 1; i < region.end; ++i) {
      const Vec3i p = mesh_.positions[out_.order[i]];
      *low = {p.x < low->x ? p.x : low->x, p.y < low->y ? p.y : low->y, p.z < low->z ? p.z : low->z};
      *high = {p.x > high->x ? p.x : high->x, p.y > high->y ? p.y : high->y, p.z > high->z ? p.z : high->z};
    }
  }

  // About the median of the coordinates along an axis, below the highest one, so that no side is empty.
  int32_t median(VertexRange region, int axis, int32_t high) const {
    uint32_t samples
        [kMostSamples];  // with the sign bit flipped, in the same order: unsigned numbers are sorted elsewhere, too
    constexpr uint32_t kSign = 0x80000000u;
    const uint32_t length = region.end - region.begin;
    // An eighth of the vertices, within these bounds: more would not balance the halves much better.
    const uint32_t wanted = length / 8 < kMostSamples ? length / 8 : kMostSamples;
    const uint32_t count = wanted > kLeastSamples ? wanted : length < kLeastSamples ? length : kLeastSamples;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t at = region.begin + static_cast<uint32_t>(static_cast<uint64_t>(i) * length / count);
      samples[i] = static_cast<uint32_t>(coordinate(mesh_.positions[out_.order[at]], axis)) ^ kSign;
    }
    sort_ascending(samples, count);
    const int32_t middle = static_cast<int32_t>(samples[(count - 1) / 2] ^ kSign);
    return middle < high ? middle : high - 1;
  }

  // Marks the region's vertices with `number`, with the side of each cut, and counts for all cuts at once.
  void count_borders(VertexRange region, uint32_t number, Cut (&cuts)[3]) const {
    for (uint32_t i = region.begin; i < region.end; ++i) {
      const uint32_t v = out_.order[i];
      uint32_t sides = 0;
      for (int axis = 0; axis < 3; ++axis)
        sides |= static_cast<uint32_t>(coordinate(mesh_.positions[v], axis) <= cuts[axis].value) << axis;
      out_.mark[v] = number << kSideBits | sides;
    }
    for (uint32_t i = region.begin; i < region.end; ++i) {
      const uint32_t v = out_.order[i], touched = touched_sides(v);
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t low = out_.mark[v] >> axis & 1, border = touched >> axis & 1;
        cuts[axis].low_count += low;
        cuts[axis].low_border += low & border;
        cuts[axis].high_border += (low ^ 1) & border;
      }
    }
  }

  // Reorders the region as low side, high side, separator. Returns the lengths of the first two through the pointers.
  void split(VertexRange region, const Cut& cut, uint32_t* low_length, uint32_t* high_length) const {
    const bool low_separates = cut.low_border <= cut.high_border;
    uint32_t low = 0, high = 0, separator = 0;
    const uint32_t length = region.end - region.begin;
    // Low side grows from the front of the scratch, the separator from its back, the high side is written in place.
    for (uint32_t i = region.begin; i < region.end; ++i) {
      const uint32_t v = out_.order[i];
      const bool on_low = (out_.mark[v] >> cut.axis & 1) != 0;
      if (on_low == low_separates && (touched_sides(v) >> cut.axis & 1) != 0) {
        out_.scratch[length - ++separator] = v;
      } else if (on_low) {
        out_.scratch[low++] = v;
      } else {
        out_.order[region.begin + high++] = v;
      }
    }
    for (uint32_t i = high; i > 0; --i) out_.order[region.begin + low + i - 1] = out_.order[region.begin + i - 1];
    for (uint32_t i = 0; i < low; ++i) out_.order[region.begin + i] = out_.scratch[i];
    for (uint32_t i = 0; i < separator; ++i) out_.order[region.begin + low + high + i] = out_.scratch[length - 1 - i];
    *low_length = low;
    *high_length = high;
  }

 private:
  // Bit i: a neighbor with the vertex's number is on the other side of cut i.
  uint32_t touched_sides(uint32_t vertex) const {
    const uint32_t own = out_.mark[vertex];
    uint32_t touched = 0;
    for (uint32_t e = mesh_.row_offsets[vertex]; e < mesh_.row_offsets[vertex + 1]; ++e) {
      const uint32_t differs = out_.mark[mesh_.col_indices[e]] ^ own;
      touched |= differs >> kSideBits == 0 ? differs : 0;
    }
    return touched;
  }

  const Mesh& mesh_;
  Ordering& out_;
};

}  // namespace

bool Ordering::allocate(Arena& arena, const Counts& counts) {
  return allocate_result(arena, counts) && allocate_scratch(arena, counts);
}

bool Ordering::allocate_scratch(Arena& arena, const Counts& counts) {
  mark = arena.alloc<uint32_t>(counts.vertices);
  scratch = arena.alloc<uint32_t>(counts.vertices);
  return arena.ok();
}

bool Ordering::allocate_result(Arena& arena, const Counts& counts) {
  order = arena.alloc<uint32_t>(counts.vertices);
  position = arena.alloc<uint32_t>(counts.vertices);
  region_size = arena.alloc<uint32_t>(counts.vertices);
  region_begin = arena.alloc<uint32_t>(counts.vertices);
  return arena.ok();
}

void Ordering::dissect(const Mesh& mesh, uint32_t part, uint32_t smallest) {
  const uint32_t first = mesh.part_offsets[part];
  const uint32_t count = mesh.part_offsets[part + 1] - first;
  for (uint32_t i = 0; i < count; ++i) order[i] = mesh.part_vertices[first + i];
  memset(region_size, 0, count * sizeof(region_size[0]));

  const Dissection dissection(mesh, *this);
  uint32_t next_number = 0;
  VertexRange
      stack[40];  // the smaller half is always taken first, so the depth is at most log2 of the vertex count + 1
  uint32_t depth = 0;
  stack[depth++] = {0, count};
  while (depth > 0) {
    const VertexRange region = stack[--depth];
    const uint32_t mine = next_number++;
    const uint32_t length = region.end - region.begin;
    if (length <= smallest) {
      region_size[region.begin] = length;
      region_begin[region.begin] = region.begin;
      continue;
    }

    // All three axes are tried: the shortest separator for the balance it gives.
    Vec3i lowest, highest;
    dissection.find_box(region, &lowest, &highest);
    Cut cuts[3];
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t high = coordinate(highest, axis);
      cuts[axis].axis = axis;
      cuts[axis].value = coordinate(lowest, axis) == high ? high : dissection.median(region, axis, high);
    }
    dissection.count_borders(region, mine, cuts);
    const auto smaller_side = [length](const Cut& c) {
      return static_cast<uint64_t>(c.low_count < length - c.low_count ? c.low_count : length - c.low_count);
    };
    Cut best;
    bool found = false;
    for (const Cut& cut : cuts) {
      if (coordinate(lowest, cut.axis) == coordinate(highest, cut.axis)) continue;
      if (!found || cut.separator() * smaller_side(best) < best.separator() * smaller_side(cut)) best = cut;
      found = true;
    }
    uint32_t low = 0, high = 0;
    dissection.split(region, best, &low, &high);
    const VertexRange low_region = {region.begin, region.begin + low};
    const VertexRange high_region = {region.begin + low, region.begin + low + high};
    if (high_region.end < region.end) {
      region_size[high_region.end] = region.end - high_region.end;
      region_begin[high_region.end] = region.begin;
    }
    const bool low_first = low <= high;
    const VertexRange later = low_first ? high_region : low_region;
    const VertexRange sooner = low_first ? low_region : high_region;
    if (later.begin < later.end) stack[depth++] = later;
    if (sooner.begin < sooner.end) stack[depth++] = sooner;
  }
  for (uint32_t i = 0; i < count; ++i) position[order[i]] = i;
}

}  // namespace sinew
