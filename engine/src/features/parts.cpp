// SPDX-License-Identifier: MIT
// Part boxes, boundaries and hosts. Hosts are found with an implicit box tree over the vertices in the order of
// parts, Morton order inside each: what may be a host of a part comes before it.
#include "features/parts.hpp"

#include <string.h>

#include "core/vector_math.hpp"

namespace sinew {
namespace {

constexpr uint32_t kLeafVertices = 16;
constexpr uint32_t kGroupVertices = 8;  // of a part, that look for their hosts together
constexpr int32_t kFar = 1 << 24;       // beyond every clamped coordinate
constexpr int kVertexBits = 22;
static_assert(SINEW_MAX_VERTICES <= 1u << kVertexBits, "below the 42 bits of a squared distance on the grid");

struct Box {
  Vec3i lo, hi;
};
constexpr Box kNothing = {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};

struct Leaf {
  int32_t x[kLeafVertices], y[kLeafVertices], z[kLeafVertices];
};

uint32_t leaf_count(uint32_t vertices) {
  uint32_t leaves = 1;
  while (static_cast<uint64_t>(leaves) * kLeafVertices < vertices) leaves *= 2;
  return leaves;
}

struct Tree {
  Box* nodes = nullptr;    // [2 x leaf_count] heap order, root = 1
  Leaf* leaves = nullptr;  // [U / kLeafVertices, rounded up]

  bool allocate(Arena& arena, const Counts& counts) {
    nodes = arena.alloc<Box>(static_cast<size_t>(2) * leaf_count(counts.vertices));
    leaves = arena.alloc<Leaf>(counts.vertices / kLeafVertices + 1);
    return arena.ok();
  }
};

uint64_t gap(int32_t lo, int32_t hi, int32_t other_lo, int32_t other_hi) {
  const int32_t under = lo - other_hi, over = other_lo - hi;
  const int32_t larger = under > over ? under : over;
  return larger > 0 ? static_cast<uint32_t>(larger) : 0;
}

uint64_t squared_difference(int32_t a, int32_t b) {
  const uint64_t d = static_cast<uint32_t>(a > b ? a - b : b - a);
  return d * d;
}

// Finds hosts by keys, squared distance << kVertexBits | vertex: the smallest is the nearest, ties the lower index.
class HostFinder {
 public:
  HostFinder(const Mesh& mesh, const Tree& tree, uint32_t* host_vertex, uint32_t* host_distance)
      : mesh_(mesh),
        nodes_(tree.nodes),
        leaves_(tree.leaves),
        host_vertex_(host_vertex),
        host_distance_(host_distance) {}

  // The tree over the first `count` vertices in the order of parts.
  void build(uint32_t count) {
    first_leaf_ = leaf_count(count);
    for (uint32_t leaf = 0; leaf < first_leaf_; ++leaf) {
      Box& box = nodes_[first_leaf_ + leaf];
      box = kNothing;
      const uint32_t first = leaf * kLeafVertices;
      for (uint32_t i = 0; i < kLeafVertices && first < count; ++i) {
        const uint32_t at =
            first + i < count ? first + i : count - 1;  // the last leaf is filled up with the last vertex
        const Vec3i p = mesh_.positions[mesh_.part_vertices[at]];
        grow(p, &box.lo, &box.hi);
        leaves_[leaf].x[i] = p.x;
        leaves_[leaf].y[i] = p.y;
        leaves_[leaf].z[i] = p.z;
      }
    }
    for (uint32_t n = first_leaf_ - 1; n >= 1; --n) {
      nodes_[n] = nodes_[2 * n];
      grow(nodes_[2 * n + 1].lo, &nodes_[n].lo, &nodes_[n].hi);
      grow(nodes_[2 * n + 1].hi, &nodes_[n].lo, &nodes_[n].hi);
    }
  }

  // Hosts of `count` vertices among the first `limit` in the order of parts. `guess` is one of those; it changes
  // the time, never the answer.
  void find(const uint32_t* vertices, uint32_t count, uint32_t limit, uint32_t guess) {
    Box around = kNothing;
    for (uint32_t m = 0; m < count; ++m) {
      at_[m] = mesh_.positions[vertices[m]];
      grow(at_[m], &around.lo, &around.hi);
      const Vec3i d = at_[m] - mesh_.positions[guess];
      best_[m] = static_cast<uint64_t>(dot(d, d)) << kVertexBits | guess;
    }
    struct Entry {
      uint64_t apart;
      uint32_t node;
    };
    Entry stack[24];  // at most one for each of 19 levels and one more
    uint32_t depth = 0;
    uint64_t worst = worst_of(count);
    stack[depth++] = {0, 1};
    while (depth > 0) {
      const Entry entry = stack[--depth];
      if (entry.apart > worst) continue;
      if (entry.node >= first_leaf_) {
        look_into(entry.node - first_leaf_, count, limit);
        worst = worst_of(count);
        continue;
      }
      Entry sooner = {apart(nodes_[2 * entry.node], around), 2 * entry.node};
      if (first_vertex(2 * entry.node + 1) < limit) {
        Entry later = {apart(nodes_[2 * entry.node + 1], around), 2 * entry.node + 1};
        if (later.apart < sooner.apart) {
          const Entry t = sooner;
          sooner = later;
          later = t;
        }
        if (later.apart <= worst) stack[depth++] = later;
      }
      stack[depth++] = sooner;
    }
    for (uint32_t m = 0; m < count; ++m) {
      host_vertex_[vertices[m]] = static_cast<uint32_t>(best_[m] & ((1u << kVertexBits) - 1));
      host_distance_[vertices[m]] = isqrt64(best_[m] >> kVertexBits);
    }
  }

 private:
  // No key of a vertex in one box for a vertex in the other is smaller. Not for empty boxes.
  static uint64_t apart(const Box& a, const Box& b) {
    const uint64_t x = gap(a.lo.x, a.hi.x, b.lo.x, b.hi.x), y = gap(a.lo.y, a.hi.y, b.lo.y, b.hi.y),
                   z = gap(a.lo.z, a.hi.z, b.lo.z, b.hi.z);
    return (x * x + y * y + z * z) << kVertexBits;
  }
  // The first of the vertices under a node, in the order of parts.
  uint32_t first_vertex(uint32_t node) const {
    return ((node << (top_bit(first_leaf_) - top_bit(node))) - first_leaf_) * kLeafVertices;
  }
  uint64_t worst_of(uint32_t count) const {
    uint64_t worst = 0;
    for (uint32_t m = 0; m < count; ++m) worst = best_[m] > worst ? best_[m] : worst;
    return worst;
  }

  void look_into(uint32_t index, uint32_t count, uint32_t limit) {
    const Leaf& leaf = leaves_[index];
    const uint32_t* const vertices = mesh_.part_vertices + static_cast<size_t>(index) * kLeafVertices;
    const uint32_t rest = limit - index * kLeafVertices, used = rest < kLeafVertices ? rest : kLeafVertices;
    for (uint32_t m = 0; m < count; ++m) {
      const Vec3i p = at_[m];
      if (apart(nodes_[first_leaf_ + index], {p, p}) > best_[m]) continue;
      uint64_t distance2[kLeafVertices];
      for (uint32_t i = 0; i < kLeafVertices; ++i) {
        distance2[i] = squared_difference(p.x, leaf.x[i]) + squared_difference(p.y, leaf.y[i]) +
                       squared_difference(p.z, leaf.z[i]);
      }
      for (uint32_t i = 0; i < used; ++i) {
        const uint64_t key = distance2[i] << kVertexBits | vertices[i];
        best_[m] = key < best_[m] ? key : best_[m];
      }
    }
  }

  const Mesh& mesh_;
  Box* const nodes_;
  Leaf* const leaves_;
  uint32_t* const host_vertex_;
  uint32_t* const host_distance_;
  uint32_t first_leaf_ = 1;
  Vec3i at_[kGroupVertices];       // the group's vertices
  uint64_t best_[kGroupVertices];  // and their keys
};

}  // namespace

bool Parts::allocate(Arena& arena, const Counts& counts) {
  host_vertex = arena.alloc<uint32_t>(counts.vertices);
  host_distance = arena.alloc<uint32_t>(counts.vertices);
  source_count = arena.alloc<uint32_t>(counts.vertices);
  boundary_count = arena.alloc<uint32_t>(counts.vertices);
  box_min = arena.alloc<Vec3i>(counts.vertices);
  box_max = arena.alloc<Vec3i>(counts.vertices);
  return arena.ok();
}

sinew_status find_hosts(const Mesh& mesh, const Counts& counts, Arena& arena, uint32_t* host_vertex,
                        uint32_t* host_distance) {
  const ArenaScope scope(arena);
  Tree tree;
  if (!tree.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  const uint32_t *const order = mesh.part_vertices, *const offsets = mesh.part_offsets;
  for (uint32_t i = 0; i < offsets[1]; ++i) {
    host_vertex[order[i]] = kNoVertex;
    host_distance[order[i]] = 0;
  }
  HostFinder finder(mesh, tree, host_vertex, host_distance);
  if (mesh.part_count > 1) finder.build(offsets[mesh.part_count - 1]);
  for (uint32_t c = 1; c < mesh.part_count; ++c) {
    uint32_t guess = order[0];
    for (uint32_t i = offsets[c]; i < offsets[c + 1]; i += kGroupVertices) {
      const uint32_t rest = offsets[c + 1] - i, count = rest < kGroupVertices ? rest : kGroupVertices;
      finder.find(order + i, count, offsets[c], guess);
      guess = host_vertex[order[i + count - 1]];  // near the next group, which is near in Morton order
    }
  }
  return SINEW_OK;
}

sinew_status find_parts(const Mesh& mesh, const HeatFields& heat, const Counts& counts, Arena& arena, Parts* parts) {
  const ArenaScope scope(arena);
  uint32_t* const triangles_at = arena.alloc<uint32_t>(counts.vertices);  // triangles around a vertex
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  const sinew_status status = find_hosts(mesh, counts, arena, parts->host_vertex, parts->host_distance);
  if (status != SINEW_OK || arena.measuring()) return status;

  memset(triangles_at, 0, mesh.welded_count * sizeof(uint32_t));
  for (size_t i = 0; i < static_cast<size_t>(mesh.triangle_count) * 3; ++i) ++triangles_at[mesh.triangles[i]];
  for (uint32_t c = 0; c < mesh.part_count; ++c) {
    parts->source_count[c] = parts->boundary_count[c] = 0;
    parts->box_min[c] = {kFar, kFar, kFar};
    parts->box_max[c] = {-kFar, -kFar, -kFar};
  }
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const uint32_t c = mesh.part[v];
    grow(mesh.positions[v], &parts->box_min[c], &parts->box_max[c]);
    parts->source_count[c] += heat.field[kFieldRule].has_source[v];
    // Around an inner vertex of a manifold there are as many triangles as neighbors; at a boundary one less.
    parts->boundary_count[c] += triangles_at[v] != mesh.row_offsets[v + 1] - mesh.row_offsets[v];
  }
  return SINEW_OK;
}

}  // namespace sinew
