// SPDX-License-Identifier: MIT
// Component boxes, boundaries and hosts. Hosts are found with an implicit box tree over the Morton-ordered vertices
// that skips subtrees holding no larger component.
#include "features/parts.hpp"

#include <string.h>

namespace sinew {
namespace {

constexpr uint32_t kLeafVertices = 8;
constexpr int32_t kFar = 1 << 24;  // beyond every clamped coordinate

struct Box {
  Vec3i lo, hi;
  uint32_t first_component;  // smallest component id inside
};

uint32_t leaf_count(uint32_t vertices) {
  uint32_t leaves = 1;
  while (static_cast<uint64_t>(leaves) * kLeafVertices < vertices) leaves *= 2;
  return leaves;
}

struct Scratch {
  Box* nodes = nullptr;              // [2 x leaves] heap order, root = 1
  uint32_t* triangles_at = nullptr;  // [U] triangles around a vertex

  bool allocate(Arena& arena, const Counts& counts) {
    nodes = arena.alloc<Box>(static_cast<size_t>(2) * leaf_count(counts.vertices));
    triangles_at = arena.alloc<uint32_t>(counts.vertices);
    return arena.ok();
  }
};

void grow(Vec3i p, Vec3i* lo, Vec3i* hi) {
  lo->x = p.x < lo->x ? p.x : lo->x;
  lo->y = p.y < lo->y ? p.y : lo->y;
  lo->z = p.z < lo->z ? p.z : lo->z;
  hi->x = p.x > hi->x ? p.x : hi->x;
  hi->y = p.y > hi->y ? p.y : hi->y;
  hi->z = p.z > hi->z ? p.z : hi->z;
}

int64_t gap(int32_t p, int32_t lo, int32_t hi) { return p < lo ? lo - p : p > hi ? p - hi : 0; }

int64_t squared_distance(Vec3i p, const Box& box) {
  const int64_t x = gap(p.x, box.lo.x, box.hi.x), y = gap(p.y, box.lo.y, box.hi.y), z = gap(p.z, box.lo.z, box.hi.z);
  return x * x + y * y + z * z;
}

void build_tree(const Mesh& mesh, uint32_t leaves, Box* nodes) {
  for (uint32_t leaf = 0; leaf < leaves; ++leaf) {
    Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}, kNoVertex};
    for (uint32_t v = leaf * kLeafVertices; v < (leaf + 1) * kLeafVertices && v < mesh.welded_count; ++v) {
      grow(mesh.positions[v], &box.lo, &box.hi);
      if (mesh.component[v] < box.first_component) box.first_component = mesh.component[v];
    }
    nodes[leaves + leaf] = box;
  }
  for (uint32_t n = leaves - 1; n >= 1; --n) {
    const Box &a = nodes[2 * n], &b = nodes[2 * n + 1];
    Box box = a;
    grow(b.lo, &box.lo, &box.hi);
    grow(b.hi, &box.lo, &box.hi);
    if (b.first_component < box.first_component) box.first_component = b.first_component;
    nodes[n] = box;
  }
}

// Nearest vertex of a component with a smaller id than `component`. `guess` is such a vertex, or kNoVertex; it changes
// the time, never the answer.
void find_host(const Mesh& mesh, const Box* nodes, uint32_t leaves, uint32_t vertex, uint32_t guess, uint32_t* host,
               uint32_t* distance) {
  const Vec3i p = mesh.positions[vertex];
  const uint32_t component = mesh.component[vertex];
  int64_t best = INT64_MAX;
  uint32_t best_vertex = guess;
  if (guess != kNoVertex) {
    const Vec3i d = mesh.positions[guess] - p;
    best = dot(d, d);
  }
  uint32_t stack[64];
  int top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const uint32_t n = stack[--top];
    if (nodes[n].first_component >= component || squared_distance(p, nodes[n]) > best) continue;
    if (n < leaves) {
      const bool left_first = squared_distance(p, nodes[2 * n]) <= squared_distance(p, nodes[2 * n + 1]);
      stack[top++] = left_first ? 2 * n + 1 : 2 * n;
      stack[top++] = left_first ? 2 * n : 2 * n + 1;
      continue;
    }
    const uint32_t first = (n - leaves) * kLeafVertices;
    for (uint32_t v = first; v < first + kLeafVertices && v < mesh.welded_count; ++v) {
      if (mesh.component[v] >= component) continue;
      const Vec3i d = mesh.positions[v] - p;
      const int64_t d2 = dot(d, d);
      if (d2 < best || (d2 == best && v < best_vertex)) {
        best = d2;
        best_vertex = v;
      }
    }
  }
  *host = best_vertex;
  *distance = best_vertex == kNoVertex ? 0 : isqrt64(static_cast<uint64_t>(best));
}

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

void measure_find_parts(Arena& arena, const Counts& counts) {
  const size_t mark = arena.mark();
  Scratch().allocate(arena, counts);
  arena.release(mark);
}

sinew_status find_parts(const Mesh& mesh, const HeatFields& heat, const Counts& counts, Arena& arena, Parts* parts) {
  const size_t mark = arena.mark();
  Scratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  const uint32_t vertices = mesh.welded_count;

  memset(scratch.triangles_at, 0, vertices * sizeof(uint32_t));
  for (size_t i = 0; i < static_cast<size_t>(mesh.triangle_count) * 3; ++i) ++scratch.triangles_at[mesh.triangles[i]];
  for (uint32_t c = 0; c < mesh.component_count; ++c) {
    parts->source_count[c] = parts->boundary_count[c] = 0;
    parts->box_min[c] = {kFar, kFar, kFar};
    parts->box_max[c] = {-kFar, -kFar, -kFar};
  }
  for (uint32_t v = 0; v < vertices; ++v) {
    const uint32_t c = mesh.component[v];
    grow(mesh.positions[v], &parts->box_min[c], &parts->box_max[c]);
    parts->source_count[c] += heat.field[kFieldRule].has_source[v];
    // Around an inner vertex of a manifold there are as many triangles as neighbours; at a boundary one less.
    parts->boundary_count[c] += scratch.triangles_at[v] != mesh.row_offsets[v + 1] - mesh.row_offsets[v];
  }

  const uint32_t leaves = leaf_count(vertices);
  build_tree(mesh, leaves, scratch.nodes);
  for (uint32_t c = 0; c < mesh.component_count; ++c) {
    uint32_t guess = kNoVertex;  // the host of the part's vertex before, which is near in Morton order
    for (uint32_t i = mesh.component_offsets[c]; i < mesh.component_offsets[c + 1]; ++i) {
      const uint32_t v = mesh.component_vertices[i];
      find_host(mesh, scratch.nodes, leaves, v, guess, &parts->host_vertex[v], &parts->host_distance[v]);
      guess = parts->host_vertex[v];
    }
  }
  arena.release(mark);
  return SINEW_OK;
}

}  // namespace sinew
