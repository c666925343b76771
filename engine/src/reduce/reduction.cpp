// SPDX-License-Identifier: MIT
// From clusters to a mesh like any other, and from its triangles back to the full mesh's vertices.
#include "reduce/reduction.hpp"

#include "core/vector_math.hpp"
#include "mesh/morton.hpp"
#include "mesh/topology.hpp"
#include "reduce/clusters.hpp"

namespace sinew {
namespace {

constexpr uint32_t kWholeShare = 32768;  // of shares

struct ReductionScratch {
  Clusters clusters;
  MortonScratch points;
  uint8_t* has_triangle;  // [n]
  uint32_t* near;         // [n x 2] nearest clusters beside one without triangles
  int64_t* distances;     // [n x 2] squared
  uint32_t* loose;        // [2n x 2] edges without triangles
  TriangleScratch triangles;
  TopologyScratch topology;

  bool allocate(Arena& arena, const Counts& counts) {
    const Counts reduced = counts.surface();
    const size_t n = reduced.vertices;
    (void)clusters.allocate(arena, counts, reduced.vertices);
    (void)points.allocate(arena, n);
    has_triangle = arena.alloc<uint8_t>(n);
    near = arena.alloc<uint32_t>(2 * n);
    distances = arena.alloc<int64_t>(2 * n);
    loose = arena.alloc<uint32_t>(4 * n);
    (void)triangles.allocate(arena, reduced);
    return topology.allocate(arena, reduced);
  }
};

// Clusters become vertices in Morton order; two with the same mean become one.
void place_vertices(const Mesh& full, const ReductionScratch& scratch, Reduction* out) {
  const Clusters& clusters = scratch.clusters;
  uint32_t used = 0;
  for (uint32_t c = 0; c < clusters.count; ++c) {
    if (clusters.sizes[c] == 0) continue;
    scratch.points.keys[used] = morton_key(clusters.centroids[c]);
    scratch.points.order[used++] = c;
  }
  uint32_t* const vertex_of = clusters.sizes;  // no longer sizes
  const uint32_t count = weld_keys(scratch.points, used, out->mesh.positions, vertex_of);
  out->mesh.reduced = true;
  out->mesh.welded_count = count;
  out->mesh.vertex_count = count;
  for (uint32_t v = 0; v < full.welded_count; ++v) out->vertex[v] = vertex_of[clusters.labels[v]];
}

// Walks the full mesh's triangles whose corners lie at three reduced vertices.
class ReducedWalk {
 public:
  ReducedWalk(const Mesh& full, const Reduction& reduction) : full_(full), reduction_(reduction) {}
  bool next(uint32_t* triangle) {
    while (at_ < full_.triangle_count) {
      const uint32_t* const corners = full_.triangles + 3 * static_cast<size_t>(at_++);
      const uint32_t a = reduction_.vertex[corners[0]], b = reduction_.vertex[corners[1]],
                     c = reduction_.vertex[corners[2]];
      if (a == b || b == c || c == a || !has_area(reduction_.mesh.positions, a, b, c)) continue;
      turn_smallest_first(a, b, c, triangle);
      return true;
    }
    return false;
  }

 private:
  const Mesh& full_;
  const Reduction& reduction_;
  uint32_t at_ = 0;
};

uint64_t count_triangles(ReducedWalk walk) {
  uint64_t count = 0;
  uint32_t t[3];
  while (walk.next(t)) ++count;
  return count;
}

void insert_near(uint32_t cluster, int64_t distance, uint32_t* near, int64_t* distances) {
  if (near[0] == cluster || near[1] == cluster) return;
  for (int position = 0; position < 2; ++position) {
    if (near[position] != kNoIndex &&
        (distances[position] < distance || (distances[position] == distance && near[position] < cluster)))
      continue;
    if (position == 0) {
      near[1] = near[0];
      distances[1] = distances[0];
    }
    near[position] = cluster;
    distances[position] = distance;
    return;
  }
}

// Edges for the vertices that no triangle holds: to the two nearest of the clusters beside theirs. Returns their
// number, at most 2 n.
uint32_t find_loose_edges(const Mesh& full, const Reduction& out, const ReductionScratch& scratch) {
  const uint32_t count = out.mesh.welded_count;
  for (uint32_t c = 0; c < count; ++c) {
    scratch.has_triangle[c] = 0;
    scratch.near[2 * c] = scratch.near[2 * c + 1] = kNoIndex;
  }
  for (size_t i = 0; i < 3 * static_cast<size_t>(out.mesh.triangle_count); ++i) {
    scratch.has_triangle[out.mesh.triangles[i]] = 1;
  }
  for (uint32_t v = 0; v < full.welded_count; ++v) {
    const uint32_t c = out.vertex[v];
    if (scratch.has_triangle[c] != 0) continue;
    for (uint32_t e = full.row_offsets[v]; e < full.row_offsets[v + 1]; ++e) {
      const uint32_t other = out.vertex[full.col_indices[e]];
      if (other == c) continue;
      const Vec3i offset = out.mesh.positions[other] - out.mesh.positions[c];
      insert_near(other, dot(offset, offset), scratch.near + 2 * c, scratch.distances + 2 * c);
    }
  }
  uint32_t edges = 0;
  for (uint32_t c = 0; c < count; ++c) {
    if (scratch.has_triangle[c] != 0) continue;
    for (int position = 0; position < 2; ++position) {
      const uint32_t other = scratch.near[2 * c + static_cast<uint32_t>(position)];
      if (other == kNoIndex) continue;
      const bool both =
          scratch.has_triangle[other] == 0 && (scratch.near[2 * other] == c || scratch.near[2 * other + 1] == c);
      if (both && other < c) continue;
      scratch.loose[2 * edges] = c;
      scratch.loose[2 * edges + 1] = other;
      ++edges;
    }
  }
  return edges;
}

// A vertex without triangles represents its cluster's share of the full surface.
void give_areas(const Mesh& full, const ReductionScratch& scratch, Reduction* out) {
  uint64_t* const areas = out->mesh.areas;
  for (uint32_t v = 0; v < full.welded_count; ++v) {
    const uint32_t c = out->vertex[v];
    if (scratch.has_triangle[c] == 0) areas[c] += full.areas[v];
  }
}

void list_fans(Reduction* out) {
  const Mesh& mesh = out->mesh;
  uint32_t* const offsets = out->fan_offsets;
  for (uint32_t v = 0; v <= mesh.welded_count; ++v) offsets[v] = 0;
  const size_t corners = 3 * static_cast<size_t>(mesh.triangle_count);
  for (size_t i = 0; i < corners; ++i) ++offsets[mesh.triangles[i]];
  sum_up(offsets, mesh.welded_count + 1);
  for (size_t i = corners; i-- > 0;) out->fans[--offsets[mesh.triangles[i]]] = static_cast<uint32_t>(i / 3);
}

// num / den in Q15, 0 <= num <= den, den > 0.
uint32_t share_of(int64_t num, int64_t den) {
  const int shift = top_bit(static_cast<uint64_t>(den)) - 44;
  if (shift > 0) {
    num >>= shift;
    den >>= shift;
  }
  return static_cast<uint32_t>(num * kWholeShare / den);
}

// Shares of the point of triangle 0, b, c that is nearest to p (Ericson 2005, "Real-Time Collision Detection", 5.1.5).
// Components below 2^14: dot products stay below 2^30, their products below 2^61.
void nearest_shares(Vec3i b, Vec3i c, Vec3i p, uint32_t* shares) {
  const int64_t bb = dot(b, b), bc = dot(b, c), cc = dot(c, c);
  const int64_t d1 = dot(b, p), d2 = dot(c, p), d3 = d1 - bb, d4 = d2 - bc, d5 = d1 - bc, d6 = d2 - cc;
  const int64_t at_c = d1 * d4 - d3 * d2, at_b = d5 * d2 - d1 * d6, at_a = d3 * d6 - d5 * d4;
  shares[1] = shares[2] = 0;
  if (d1 <= 0 && d2 <= 0) {
  } else if (d3 >= 0 && d4 <= d3) {
    shares[1] = kWholeShare;
  } else if (at_c <= 0 && d1 >= 0 && d3 <= 0) {
    shares[1] = d1 - d3 > 0 ? share_of(d1, d1 - d3) : 0;
  } else if (d6 >= 0 && d5 <= d6) {
    shares[2] = kWholeShare;
  } else if (at_b <= 0 && d2 >= 0 && d6 <= 0) {
    shares[2] = d2 - d6 > 0 ? share_of(d2, d2 - d6) : 0;
  } else if (at_a <= 0 && d4 >= d3 && d5 >= d6) {
    shares[2] = share_of(d4 - d3, d4 - d3 + d5 - d6);
    shares[1] = kWholeShare - shares[2];
  } else {
    shares[1] = share_of(at_b, at_a + at_b + at_c);
    shares[2] = share_of(at_c, at_a + at_b + at_c);
  }
  shares[0] = kWholeShare - shares[1] - shares[2];
}

uint32_t size_of(Vec3i v) { return static_cast<uint32_t>(abs64(v.x) | abs64(v.y) | abs64(v.z)); }
Vec3i shifted(Vec3i v, int shift) { return {v.x >> shift, v.y >> shift, v.z >> shift}; }

// Tries one simplex of the reduced mesh, of three corners or of two (the third twice the second).
class NearestPosition {
 public:
  NearestPosition(const Mesh& mesh, Vec3i point, uint32_t vertex) : mesh_(mesh), point_(point) {
    const Vec3i offset = point - mesh.positions[vertex];
    position_ = {{vertex, vertex, vertex}, {kWholeShare, 0, 0}};
    distance_ = dot(offset, offset);
  }
  void offer(uint32_t a, uint32_t b, uint32_t c) {
    const Vec3i origin = mesh_.positions[a];
    const Vec3i to_b = mesh_.positions[b] - origin, to_c = mesh_.positions[c] - origin, to_p = point_ - origin;
    const int top = top_bit(size_of(to_b) | size_of(to_c) | size_of(to_p));
    const int shift = top > 12 ? top - 12 : 0;
    SurfacePosition position = {{a, b, c}, {0, 0, 0}};
    nearest_shares(shifted(to_b, shift), shifted(to_c, shift), shifted(to_p, shift), position.shares);
    const int64_t s = position.shares[1], t = position.shares[2];
    const Vec3i gap = {static_cast<int32_t>(to_p.x - ((to_b.x * s + to_c.x * t) >> 15)),
                       static_cast<int32_t>(to_p.y - ((to_b.y * s + to_c.y * t) >> 15)),
                       static_cast<int32_t>(to_p.z - ((to_b.z * s + to_c.z * t) >> 15))};
    const int64_t distance = dot(gap, gap);
    if (distance >= distance_) return;
    distance_ = distance;
    position_ = position;
  }
  SurfacePosition position() const { return position_; }

 private:
  const Mesh& mesh_;
  const Vec3i point_;
  SurfacePosition position_;
  int64_t distance_;  // squared
};

uint32_t own_share(const SurfacePosition& position, uint32_t vertex) {
  uint32_t share = 0;
  for (int i = 0; i < 3; ++i) share += position.vertices[i] == vertex ? position.shares[i] : 0;
  return share;
}

}  // namespace

bool Reduction::allocate(Arena& arena, const Counts& counts) {
  const Counts reduced = counts.surface();
  (void)mesh.allocate(arena, reduced);
  vertex = arena.alloc<uint32_t>(counts.vertices);
  fan_offsets = arena.alloc<uint32_t>(static_cast<size_t>(reduced.vertices) + 1);
  fans = arena.alloc<uint32_t>(3 * static_cast<size_t>(reduced.triangles()));
  return arena.ok();
}

SurfacePosition Reduction::position(const Mesh& full, uint32_t full_vertex) const {
  const uint32_t own = vertex[full_vertex];
  NearestPosition nearest(mesh, full.positions[full_vertex], own);
  const auto offer_fan = [&](uint32_t corner) {
    for (uint32_t i = fan_offsets[corner]; i < fan_offsets[corner + 1]; ++i) {
      const uint32_t* const t = mesh.triangles + 3 * static_cast<size_t>(fans[i]);
      nearest.offer(t[0], t[1], t[2]);
    }
  };
  offer_fan(own);
  // On the rim of the fan: what lies behind may be nearer.
  const SurfacePosition rim = nearest.position();
  for (int i = 0; i < 3 && own_share(rim, own) == 0; ++i) {
    if (rim.shares[i] != 0) offer_fan(rim.vertices[i]);
  }
  if (fan_offsets[own] == fan_offsets[own + 1]) {
    for (uint32_t e = mesh.row_offsets[own]; e < mesh.row_offsets[own + 1]; ++e) {
      nearest.offer(own, mesh.col_indices[e], mesh.col_indices[e]);
    }
  }
  return nearest.position();
}

sinew_status reduce_mesh(const Mesh& full, const Counts& counts, const Progress& progress, Arena& arena,
                         Reduction* out) {
  const Counts reduced = counts.surface();
  out->active = full.welded_count > reduced.vertices || full.triangle_count > reduced.triangles();
  if (!out->active && !arena.measuring()) return SINEW_OK;
  const ArenaScope scope(arena);
  ReductionScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  uint32_t loose = 0;
  // Almost always at once; only a surface that meets itself everywhere has more than four triangles a vertex.
  for (uint32_t most = reduced.vertices;; most /= 2) {
    if (!progress.report(0)) return SINEW_ERROR_CANCELLED;
    find_clusters(full, most, counts.threads, &scratch.clusters);
    place_vertices(full, scratch, out);
    if (count_triangles(ReducedWalk(full, *out)) > reduced.triangles()) continue;
    collect_triangles(ReducedWalk(full, *out), scratch.triangles, &out->mesh);
    loose = find_loose_edges(full, *out, scratch);
    if (6 * uint64_t{out->mesh.triangle_count} + 2 * loose <= 6 * uint64_t{reduced.triangles()}) break;
  }
  connect(scratch.loose, loose, scratch.topology, &out->mesh);
  label_parts(scratch.topology, &out->mesh);
  find_shape(scratch.topology.shape, counts.threads, &out->mesh);
  give_areas(full, scratch, out);
  list_fans(out);
  return progress.report(1000) ? SINEW_OK : SINEW_ERROR_CANCELLED;
}

}  // namespace sinew
