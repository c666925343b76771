// SPDX-License-Identifier: MIT
// Triangles, one-ring and parts in canonical order. Every order is an order of values, never of the input's
// numbering.
#include "mesh/topology.hpp"

#include "core/vector_math.hpp"

namespace sinew {

bool has_area(const Vec3i* positions, uint32_t a, uint32_t b, uint32_t c) {
  const Vec3l normal = cross(positions[b] - positions[a], positions[c] - positions[a]);
  return normal.x != 0 || normal.y != 0 || normal.z != 0;
}

void finish_triangles(const TriangleScratch& scratch, Mesh* mesh) {
  const uint32_t count = mesh->welded_count;
  mesh->triangle_count = 0;
  for (uint32_t v = 0; v < count; ++v) {
    uint64_t* const keys = scratch.keys + scratch.offsets[v];
    const uint32_t size = scratch.offsets[v + 1] - scratch.offsets[v];
    sort_ascending(keys, size);
    uint32_t kept = 0;
    for (uint32_t i = 0; i < size; ++i) {
      if (i > 0 && (keys[i] >> 1) == (keys[i - 1] >> 1)) continue;
      scratch.keys[scratch.offsets[v] + kept++] = keys[i];
    }
    for (uint32_t i = 0; i < kept; ++i) {
      const uint32_t low = static_cast<uint32_t>(keys[i] >> 33),
                     high = static_cast<uint32_t>((keys[i] >> 1) & 0xFFFFFFFFu);
      keys[i] = (keys[i] & 1u) != 0 ? pack_pair(high, low) : pack_pair(low, high);
    }
    sort_ascending(keys, kept);
    for (uint32_t i = 0; i < kept; ++i) {
      uint32_t* const out = mesh->triangles + 3 * static_cast<size_t>(mesh->triangle_count++);
      out[0] = v;
      out[1] = static_cast<uint32_t>(keys[i] >> 32);
      out[2] = static_cast<uint32_t>(keys[i] & 0xFFFFFFFFu);
    }
  }
}

// CSR one-ring. Each triangle enters every vertex's row twice; what a row holds only once is a boundary edge.
void connect(const uint32_t* loose, uint32_t loose_count, const TopologyScratch& scratch, Mesh* mesh) {
  uint8_t* const boundary = scratch.shape.boundary;
  const uint32_t count = mesh->welded_count;
  uint32_t* const offsets = mesh->row_offsets;
  for (uint32_t v = 0; v <= count; ++v) offsets[v] = 0;
  const size_t corners = 3 * static_cast<size_t>(mesh->triangle_count);
  for (size_t c = 0; c < corners; ++c) offsets[mesh->triangles[c]] += 2;
  for (uint32_t i = 0; i < 2 * loose_count; ++i) ++offsets[loose[i]];
  sum_up(offsets, count + 1);
  for (size_t c = 0; c < corners; ++c) {
    const size_t base = c - c % 3;
    const uint32_t v = mesh->triangles[c];
    mesh->col_indices[--offsets[v]] = mesh->triangles[base + (c + 1) % 3];
    mesh->col_indices[--offsets[v]] = mesh->triangles[base + (c + 2) % 3];
  }
  for (uint32_t i = 0; i < 2 * loose_count; ++i) mesh->col_indices[--offsets[loose[i]]] = loose[i ^ 1];
  uint32_t used = 0;
  for (uint32_t v = 0; v < count; ++v) {
    const uint32_t begin = offsets[v], end = offsets[v + 1];  // not yet moved: `used` never overtakes `begin`
    sort_ascending(mesh->col_indices + begin, end - begin);
    boundary[v] = 0;
    offsets[v] = used;
    for (uint32_t i = begin; i < end;) {
      const uint32_t neighbor = mesh->col_indices[i];
      const uint32_t run = i;
      while (i < end && mesh->col_indices[i] == neighbor) ++i;
      if (i - run == 1) boundary[v] = 1;
      mesh->col_indices[used++] = neighbor;
    }
  }
  offsets[count] = used;
}

// Breadth-first labeling, then ids by descending size and first vertex.
void label_parts(const TopologyScratch& scratch, Mesh* mesh) {
  const uint32_t count = mesh->welded_count;
  for (uint32_t v = 0; v < count; ++v) mesh->part[v] = kNoIndex;
  uint32_t* const queue = mesh->part_vertices;
  uint32_t found = 0, tail = 0;
  for (uint32_t seed = 0; seed < count; ++seed) {
    if (mesh->part[seed] != kNoIndex) continue;
    const uint32_t begin = tail;
    mesh->part[seed] = found;
    queue[tail++] = seed;
    for (uint32_t head = begin; head < tail; ++head) {
      const uint32_t v = queue[head];
      for (uint32_t e = mesh->row_offsets[v]; e < mesh->row_offsets[v + 1]; ++e) {
        const uint32_t neighbor = mesh->col_indices[e];
        if (mesh->part[neighbor] != kNoIndex) continue;
        mesh->part[neighbor] = found;
        queue[tail++] = neighbor;
      }
    }
    scratch.part_keys[found] = pack_pair(count - (tail - begin), found);
    ++found;
  }
  sort_ascending(scratch.part_keys, found);
  mesh->part_count = found;
  mesh->part_offsets[0] = 0;
  for (uint32_t id = 0; id < found; ++id) {
    const uint32_t size = count - static_cast<uint32_t>(scratch.part_keys[id] >> 32);
    scratch.labels[scratch.part_keys[id] & 0xFFFFFFFFu] = id;
    mesh->part_sizes[id] = size;
    mesh->part_offsets[id + 1] = mesh->part_offsets[id] + size;
  }
  uint32_t* const cursors = scratch.labels;
  for (uint32_t v = 0; v < count; ++v) mesh->part[v] = scratch.labels[mesh->part[v]];
  for (uint32_t id = 0; id < found; ++id) cursors[id] = mesh->part_offsets[id];
  for (uint32_t v = 0; v < count; ++v) mesh->part_vertices[cursors[mesh->part[v]]++] = v;
}

}  // namespace sinew
