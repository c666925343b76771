// SPDX-License-Identifier: MIT
// Stage 2 of a bind: weld, Morton order, triangles, one-ring and components. Every order is an order of values, never
// of the caller's numbering, so renumbered input gives the same mesh.
#include "mesh/mesh.hpp"

#include "core/sort.hpp"
#include "mesh/quantize.hpp"
#include "mesh/skeleton.hpp"
#include "mesh/surface.hpp"
#include "mesh/vector_math.hpp"

namespace sinew {
namespace {

constexpr uint32_t kUnseen = 0xFFFFFFFFu;

// Scratch of the three phases; they do not overlap in time, so each starts at the same mark.
struct WeldScratch {
  uint64_t* keys;
  uint64_t* other_keys;
  uint32_t* order;
  uint32_t* other_order;
  bool allocate(Arena& arena, const Counts& counts) {
    keys = arena.alloc<uint64_t>(counts.vertices);
    other_keys = arena.alloc<uint64_t>(counts.vertices);
    order = arena.alloc<uint32_t>(counts.vertices);
    other_order = arena.alloc<uint32_t>(counts.vertices);
    return arena.ok();
  }
};
struct TriangleScratch {
  uint64_t* keys;     // [T] the two other corners of a triangle, grouped by its smallest
  uint32_t* offsets;  // [U + 1]
  bool allocate(Arena& arena, const Counts& counts) {
    keys = arena.alloc<uint64_t>(counts.triangles());
    offsets = arena.alloc<uint32_t>(static_cast<size_t>(counts.vertices) + 1);
    return arena.ok();
  }
};
struct TopologyScratch {
  SurfaceScratch surface;
  uint64_t* component_keys;  // [U]
  uint32_t* labels;          // [U]
  bool allocate(Arena& arena, const Counts& counts) {
    surface.boundary = arena.alloc<uint8_t>(counts.vertices);
    surface.normal_sums = arena.alloc<Vec3l>(counts.vertices);
    surface.angle_sums = arena.alloc<int64_t>(counts.vertices);
    component_keys = arena.alloc<uint64_t>(counts.vertices);
    labels = arena.alloc<uint32_t>(counts.vertices);
    return arena.ok();
  }
};

// 21-bit coordinate to every third bit and back.
uint64_t spread_bits(uint32_t value) {
  uint64_t v = value;
  v = (v | (v << 32)) & 0x001F00000000FFFFull;
  v = (v | (v << 16)) & 0x001F0000FF0000FFull;
  v = (v | (v << 8)) & 0x100F00F00F00F00Full;
  v = (v | (v << 4)) & 0x10C30C30C30C30C3ull;
  v = (v | (v << 2)) & 0x1249249249249249ull;
  return v;
}
uint32_t gather_bits(uint64_t key) {
  uint64_t v = key & 0x1249249249249249ull;
  v = (v | (v >> 2)) & 0x10C30C30C30C30C3ull;
  v = (v | (v >> 4)) & 0x100F00F00F00F00Full;
  v = (v | (v >> 8)) & 0x001F0000FF0000FFull;
  v = (v | (v >> 16)) & 0x001F00000000FFFFull;
  v = (v | (v >> 32)) & 0x00000000001FFFFFull;
  return static_cast<uint32_t>(v);
}
// Mesh coordinates are x, z in [-2^19, 2^19] and y in [0, 2^20]; the shift makes x and z non-negative.
uint64_t morton_key(Vec3i p) {
  return spread_bits(static_cast<uint32_t>(p.x + kSide / 2)) | (spread_bits(static_cast<uint32_t>(p.y)) << 1) |
         (spread_bits(static_cast<uint32_t>(p.z + kSide / 2)) << 2);
}
Vec3i position_of_key(uint64_t key) {
  return {static_cast<int32_t>(gather_bits(key)) - kSide / 2, static_cast<int32_t>(gather_bits(key >> 1)),
          static_cast<int32_t>(gather_bits(key >> 2)) - kSide / 2};
}

void weld(const sinew_mesh& input, const Quantizer& quantizer, const WeldScratch& scratch, Mesh* mesh) {
  const uint32_t count = input.vertex_count;
  for (uint32_t v = 0; v < count; ++v) {
    scratch.keys[v] = morton_key(quantize_point(quantizer, input.positions + 3 * static_cast<size_t>(v)));
    scratch.order[v] = v;
  }
  radix_sort_pairs(scratch.keys, scratch.order, count, scratch.other_keys, scratch.other_order);
  uint32_t welded = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (i == 0 || scratch.keys[i] != scratch.keys[i - 1]) mesh->positions[welded++] = position_of_key(scratch.keys[i]);
    mesh->vertex_to_welded[scratch.order[i]] = welded - 1;
  }
  mesh->vertex_count = count;
  mesh->welded_count = welded;
}

sinew_status check_faces(const sinew_mesh& input) {
  if (input.face_offsets == nullptr) {
    if (static_cast<uint64_t>(input.face_count) * 3 != input.corner_count) return SINEW_ERROR_INDEX;
  } else if (input.face_count > 0) {
    if (input.face_offsets[0] != 0 || input.face_offsets[input.face_count] != input.corner_count)
      return SINEW_ERROR_INDEX;
    for (uint32_t f = 0; f < input.face_count; ++f) {
      if (input.face_offsets[f] > input.face_offsets[f + 1]) return SINEW_ERROR_INDEX;
      if (input.face_offsets[f + 1] - input.face_offsets[f] < 2) return SINEW_ERROR_INDEX;
    }
  } else if (input.corner_count != 0) {
    return SINEW_ERROR_INDEX;
  }
  for (uint32_t c = 0; c < input.corner_count; ++c) {
    if (input.face_vertices[c] >= input.vertex_count) return SINEW_ERROR_INDEX;
  }
  return SINEW_OK;
}

// Walks the fan triangles of a polygon mesh in welded indices, smallest first, degenerate ones left out.
class FanWalk {
 public:
  FanWalk(const sinew_mesh& input, const Mesh& mesh) : input_(input), mesh_(mesh) { open_face(); }

  // False at the end. triangle [3] out.
  bool next(uint32_t* triangle) {
    while (face_ < input_.face_count) {
      if (corner_ + 2 > last_) {  // corner_ + 1 is the triangle's last corner
        ++face_;
        open_face();
        continue;
      }
      const uint32_t a = welded(first_), b = welded(corner_), c = welded(corner_ + 1);
      ++corner_;
      const Vec3l normal = cross(mesh_.positions[b] - mesh_.positions[a], mesh_.positions[c] - mesh_.positions[a]);
      if (normal.x == 0 && normal.y == 0 && normal.z == 0) continue;  // a repeated vertex too
      const int turn = a < b ? (a < c ? 0 : 2) : (b < c ? 1 : 2);
      triangle[0] = turn == 0 ? a : turn == 1 ? b : c;
      triangle[1] = turn == 0 ? b : turn == 1 ? c : a;
      triangle[2] = turn == 0 ? c : turn == 1 ? a : b;
      return true;
    }
    return false;
  }

 private:
  void open_face() {
    if (face_ >= input_.face_count) return;
    first_ = input_.face_offsets != nullptr ? input_.face_offsets[face_] : static_cast<uint64_t>(face_) * 3;
    last_ = input_.face_offsets != nullptr ? input_.face_offsets[face_ + 1] : first_ + 3;
    corner_ = first_ + 1;
  }
  uint32_t welded(uint64_t corner) const { return mesh_.vertex_to_welded[input_.face_vertices[corner]]; }

  const sinew_mesh& input_;
  const Mesh& mesh_;
  uint32_t face_ = 0;
  uint64_t first_ = 0, last_ = 0, corner_ = 0;
};

uint64_t pack(uint32_t high, uint32_t low) { return (static_cast<uint64_t>(high) << 32) | low; }

// Groups triangles by their smallest vertex, sorts each group and drops all but the first of every vertex set.
void collect_triangles(const sinew_mesh& input, const TriangleScratch& scratch, Mesh* mesh) {
  const uint32_t count = mesh->welded_count;
  for (uint32_t v = 0; v <= count; ++v) scratch.offsets[v] = 0;
  uint32_t t[3];
  for (FanWalk walk(input, *mesh); walk.next(t);) ++scratch.offsets[t[0]];
  uint32_t total = 0;
  for (uint32_t v = 0; v <= count; ++v) {  // offsets[v] = end of group v, counted down to its begin while filling
    total += scratch.offsets[v];
    scratch.offsets[v] = total;
  }
  for (FanWalk walk(input, *mesh); walk.next(t);) {
    // Sorted by vertex set first: (smaller, larger), the orientation in the lowest bit. Indices stay below 2^22.
    const bool swapped = t[1] > t[2];
    scratch.keys[--scratch.offsets[t[0]]] =
        (pack(swapped ? t[2] : t[1], swapped ? t[1] : t[2]) << 1) | (swapped ? 1u : 0u);
  }
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
      keys[i] = (keys[i] & 1u) != 0 ? pack(high, low) : pack(low, high);
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
void connect(uint8_t* boundary, Mesh* mesh) {
  const uint32_t count = mesh->welded_count;
  uint32_t* const offsets = mesh->row_offsets;
  for (uint32_t v = 0; v <= count; ++v) offsets[v] = 0;
  const size_t corners = 3 * static_cast<size_t>(mesh->triangle_count);
  for (size_t c = 0; c < corners; ++c) offsets[mesh->triangles[c]] += 2;
  uint32_t total = 0;
  for (uint32_t v = 0; v <= count; ++v) {
    total += offsets[v];
    offsets[v] = total;
  }
  for (size_t c = 0; c < corners; ++c) {
    const size_t base = c - c % 3;
    const uint32_t v = mesh->triangles[c];
    mesh->col_indices[--offsets[v]] = mesh->triangles[base + (c + 1) % 3];
    mesh->col_indices[--offsets[v]] = mesh->triangles[base + (c + 2) % 3];
  }
  uint32_t used = 0;
  for (uint32_t v = 0; v < count; ++v) {
    const uint32_t begin = offsets[v], end = offsets[v + 1];  // not yet moved: `used` never overtakes `begin`
    sort_ascending(mesh->col_indices + begin, end - begin);
    boundary[v] = 0;
    offsets[v] = used;
    for (uint32_t i = begin; i < end;) {
      const uint32_t neighbour = mesh->col_indices[i];
      const uint32_t run = i;
      while (i < end && mesh->col_indices[i] == neighbour) ++i;
      if (i - run == 1) boundary[v] = 1;
      mesh->col_indices[used++] = neighbour;
    }
  }
  offsets[count] = used;
}

// Breadth-first labelling, then ids by falling size and first vertex.
void find_components(const TopologyScratch& scratch, Mesh* mesh) {
  const uint32_t count = mesh->welded_count;
  for (uint32_t v = 0; v < count; ++v) mesh->component[v] = kUnseen;
  uint32_t* const queue = mesh->component_vertices;
  uint32_t found = 0, tail = 0;
  for (uint32_t seed = 0; seed < count; ++seed) {
    if (mesh->component[seed] != kUnseen) continue;
    const uint32_t begin = tail;
    mesh->component[seed] = found;
    queue[tail++] = seed;
    for (uint32_t head = begin; head < tail; ++head) {
      const uint32_t v = queue[head];
      for (uint32_t e = mesh->row_offsets[v]; e < mesh->row_offsets[v + 1]; ++e) {
        const uint32_t neighbour = mesh->col_indices[e];
        if (mesh->component[neighbour] != kUnseen) continue;
        mesh->component[neighbour] = found;
        queue[tail++] = neighbour;
      }
    }
    scratch.component_keys[found] = pack(count - (tail - begin), found);
    ++found;
  }
  sort_ascending(scratch.component_keys, found);
  mesh->component_count = found;
  mesh->component_offsets[0] = 0;
  for (uint32_t id = 0; id < found; ++id) {
    const uint32_t size = count - static_cast<uint32_t>(scratch.component_keys[id] >> 32);
    scratch.labels[scratch.component_keys[id] & 0xFFFFFFFFu] = id;
    mesh->component_sizes[id] = size;
    mesh->component_offsets[id + 1] = mesh->component_offsets[id] + size;
  }
  uint32_t* const cursors = scratch.labels;
  for (uint32_t v = 0; v < count; ++v) mesh->component[v] = scratch.labels[mesh->component[v]];
  for (uint32_t id = 0; id < found; ++id) cursors[id] = mesh->component_offsets[id];
  for (uint32_t v = 0; v < count; ++v) mesh->component_vertices[cursors[mesh->component[v]]++] = v;
}

}  // namespace

bool Mesh::allocate(Arena& arena, const Counts& counts) {
  const size_t v = counts.vertices, t = counts.triangles();
  vertex_to_welded = arena.alloc<uint32_t>(v);
  positions = arena.alloc<Vec3i>(v);
  triangles = arena.alloc<uint32_t>(3 * t);
  row_offsets = arena.alloc<uint32_t>(v + 1);
  col_indices = arena.alloc<uint32_t>(6 * t);
  normals = arena.alloc<Vec3i>(v);
  areas = arena.alloc<uint64_t>(v);
  mean_curvature = arena.alloc<int32_t>(v);
  gauss_curvature = arena.alloc<int32_t>(v);
  edge_length = arena.alloc<uint32_t>(v);
  component = arena.alloc<uint32_t>(v);
  component_sizes = arena.alloc<uint32_t>(v);
  component_offsets = arena.alloc<uint32_t>(v + 1);
  component_vertices = arena.alloc<uint32_t>(v);
  return arena.ok();
}

sinew_status build_mesh(const sinew_mesh& input, const sinew_skeleton& skeleton_input, uint32_t up_axis,
                        const Counts& counts, Arena& arena, Mesh* mesh, Skeleton* skeleton) {
  Quantizer quantizer;
  sinew_status status = make_quantizer(input.positions, input.vertex_count, up_axis, &quantizer);
  if (status == SINEW_OK) status = check_faces(input);
  if (status == SINEW_OK) status = build_skeleton(skeleton_input, quantizer, skeleton);
  if (status != SINEW_OK) return status;

  const size_t mark = arena.mark();
  WeldScratch weld_scratch;
  if (!weld_scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  weld(input, quantizer, weld_scratch, mesh);
  arena.release(mark);

  TriangleScratch triangle_scratch;
  if (!triangle_scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  collect_triangles(input, triangle_scratch, mesh);
  arena.release(mark);

  TopologyScratch topology_scratch;
  if (!topology_scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  connect(topology_scratch.surface.boundary, mesh);
  find_components(topology_scratch, mesh);
  measure_surface(topology_scratch.surface, counts.threads, mesh);
  arena.release(mark);

  find_sources(*mesh, skeleton);
  return SINEW_OK;
}

void measure_build_mesh(Arena& arena, const Counts& counts) {
  const size_t mark = arena.mark();
  WeldScratch().allocate(arena, counts);
  arena.release(mark);
  TriangleScratch().allocate(arena, counts);
  arena.release(mark);
  TopologyScratch().allocate(arena, counts);
  arena.release(mark);
}

}  // namespace sinew
