// SPDX-License-Identifier: MIT
// Parts alike, by sorting them by counts and size.
#include "weights/alike_parts.hpp"

#include "core/sort.hpp"
#include "core/vector_math.hpp"

namespace sinew {
namespace {

constexpr uint32_t kSameRadius = kSide / 256;
constexpr uint32_t kSamePosition = kSide / 64;
// By how much a joint of another kind has to lie better: one that the part's weight is for, and any.
constexpr uint32_t kLikelyHandicap = kSide / 256, kOtherHandicap = kSide / 64;

struct AlikeScratch {
  uint32_t* triangles = nullptr;  // [parts]
  uint32_t* order = nullptr;      // [parts]

  bool allocate(Arena& arena, const Counts& counts) {
    triangles = arena.alloc<uint32_t>(counts.vertices);
    order = arena.alloc<uint32_t>(counts.vertices);
    return arena.ok();
  }
};

SINEW_RARE void measure_part(const Mesh& mesh, uint32_t part, AlikeParts* alike) {
  const uint32_t begin = mesh.part_offsets[part], end = mesh.part_offsets[part + 1];
  Vec3l sum = {0, 0, 0};
  for (uint32_t i = begin; i < end; ++i) {
    const Vec3i p = mesh.positions[mesh.part_vertices[i]];
    sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  }
  const Vec3i center = round_div(sum, end - begin);
  uint64_t distances = 0;  // 2^22 vertices of at most 2^22
  for (uint32_t i = begin; i < end; ++i) distances += length(mesh.positions[mesh.part_vertices[i]] - center);
  alike->center[part] = center;
  alike->radius[part] = static_cast<uint32_t>(distances / (end - begin));
}

uint32_t difference(uint32_t a, uint32_t b) { return a > b ? a - b : b - a; }

uint32_t distance(const Skeleton& skeleton, uint32_t joint, Vec3i from) {
  return static_cast<uint32_t>(length(skeleton.positions[joint] - from));
}

}  // namespace

bool AlikeParts::allocate(Arena& arena, const Counts& counts) {
  first = arena.alloc<uint32_t>(counts.vertices);
  next = arena.alloc<uint32_t>(counts.vertices);
  center = arena.alloc<Vec3i>(counts.vertices);
  radius = arena.alloc<uint32_t>(counts.vertices);
  return arena.ok();
}

SINEW_RARE sinew_status find_alike_parts(const Mesh& mesh, const Counts& counts, Arena& arena, AlikeParts* alike) {
  const ArenaScope scope(arena);
  AlikeScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  const uint32_t parts = mesh.part_count;
  for (uint32_t p = 0; p < parts; ++p) {
    scratch.triangles[p] = 0;
    scratch.order[p] = p;
    measure_part(mesh, p, alike);
  }
  for (uint32_t t = 0; t < mesh.triangle_count; ++t)
    ++scratch.triangles[mesh.part[mesh.triangles[static_cast<size_t>(t) * 3]]];
  // Numbers of parts fall with their sizes, so that parts of one size are neighbors already.
  heap_sort(scratch.order, parts, [&](uint32_t a, uint32_t b) {
    if (mesh.part_sizes[a] != mesh.part_sizes[b]) return mesh.part_sizes[a] > mesh.part_sizes[b];
    if (scratch.triangles[a] != scratch.triangles[b]) return scratch.triangles[a] < scratch.triangles[b];
    if (alike->radius[a] != alike->radius[b]) return alike->radius[a] < alike->radius[b];
    return a < b;
  });
  for (uint32_t begin = 0, end = 0; begin < parts; begin = end) {
    const uint32_t leader = scratch.order[begin];
    uint32_t lowest = leader;
    for (end = begin; end < parts; ++end) {
      const uint32_t p = scratch.order[end];
      if (mesh.part_sizes[p] != mesh.part_sizes[leader] || scratch.triangles[p] != scratch.triangles[leader] ||
          alike->radius[p] - alike->radius[leader] > kSameRadius)
        break;
      lowest = p < lowest ? p : lowest;
    }
    // The first comes first, so that a walk from it meets all.
    uint32_t last = lowest;
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t p = scratch.order[i];
      alike->first[p] = lowest;
      if (p == lowest) continue;
      alike->next[last] = p;
      last = p;
    }
    alike->next[last] = AlikeParts::kNoPart;
  }
  return SINEW_OK;
}

SINEW_RARE uint16_t counterpart(const Skeleton& skeleton, const AlikeParts& alike, const uint16_t* favorites,
                                uint16_t joint, uint32_t from, uint32_t to) {
  if (from == to) return joint;
  const uint32_t wanted = distance(skeleton, joint, alike.center[from]);
  uint32_t least = difference(distance(skeleton, joint, alike.center[to]), wanted);
  if (least <= kSamePosition + wanted / 8) return joint;
  least /= 2;  // another joint has to lie clearly better
  uint16_t best = joint;
  const auto consider = [&](uint32_t other, uint32_t handicap) {
    if (skeleton.usable[other] == 0) return;
    const uint32_t off = difference(distance(skeleton, other, alike.center[to]), wanted) + handicap;
    if (off >= least) return;
    least = off;
    best = static_cast<uint16_t>(other);
  };
  for (uint32_t other = 0; other < skeleton.joint_count; ++other) {
    const bool same_kind =
        skeleton.depth[other] == skeleton.depth[joint] && skeleton.child_count[other] == skeleton.child_count[joint];
    const bool likely = other == favorites[to];
    consider(other, same_kind ? 0 : likely ? kLikelyHandicap : kOtherHandicap);
  }
  return best;
}

}  // namespace sinew
