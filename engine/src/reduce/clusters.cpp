// SPDX-License-Identifier: MIT
// Seeds, breadth-first growth and Lloyd rounds over the one-ring.
#include "reduce/clusters.hpp"

#include "core/vector_math.hpp"

namespace sinew {
namespace {

constexpr uint32_t kLloydRounds = 4;
constexpr uint32_t kClusterPiece = 1024;  // vertices that a lane takes at a time

// Seeds at every step-th vertex of the first `part_count` parts, and what is nearest to each by edges.
void grow(const Mesh& mesh, uint32_t part_count, uint32_t step, Clusters* clusters) {
  uint32_t* const labels = clusters->labels;
  uint32_t* const queue = clusters->other;
  uint32_t tail = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) labels[v] = kNoIndex;
  for (uint32_t c = 0; c < part_count; ++c) {
    for (uint32_t i = mesh.part_offsets[c]; i < mesh.part_offsets[c + 1]; i += step) {
      labels[mesh.part_vertices[i]] = tail;
      queue[tail++] = mesh.part_vertices[i];
    }
  }
  clusters->count = tail;
  for (uint32_t head = 0; head < tail; ++head) {
    const uint32_t v = queue[head];
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      const uint32_t neighbor = mesh.col_indices[e];
      if (labels[neighbor] != kNoIndex) continue;
      labels[neighbor] = labels[v];
      queue[tail++] = neighbor;
    }
  }
}

// The parts from `first` on, the smallest, whole: runs of them in Morton order share a cluster of `most` more.
void join_parts(const Mesh& mesh, uint32_t first, uint32_t most, Clusters* clusters) {
  const uint64_t joined = mesh.part_count - first;
  const uint64_t groups = joined < most ? joined : most;
  uint32_t* const label_of = clusters->other;  // [parts]
  uint64_t seen = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const uint32_t c = mesh.part[v];
    if (c < first) continue;
    if (v == mesh.part_vertices[mesh.part_offsets[c]]) {
      label_of[c] = clusters->count + static_cast<uint32_t>(seen++ * groups / joined);
    }
    clusters->labels[v] = label_of[c];
  }
  clusters->count += static_cast<uint32_t>(groups);
}

void find_centroids(const Mesh& mesh, Clusters* clusters) {
  for (uint32_t c = 0; c < clusters->count; ++c) {
    clusters->sums[c] = {0, 0, 0};
    clusters->sizes[c] = 0;
  }
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    Vec3l& sum = clusters->sums[clusters->labels[v]];
    sum.x += mesh.positions[v].x;
    sum.y += mesh.positions[v].y;
    sum.z += mesh.positions[v].z;
    ++clusters->sizes[clusters->labels[v]];
  }
  for (uint32_t c = 0; c < clusters->count; ++c) {
    const int64_t size = clusters->sizes[c];
    if (size == 0) continue;
    const Vec3l sum = clusters->sums[c];
    clusters->centroids[c] = {static_cast<int32_t>(round_div(sum.x, size)),
                              static_cast<int32_t>(round_div(sum.y, size)),
                              static_cast<int32_t>(round_div(sum.z, size))};
  }
}

// The cluster of the vertex or of a neighbor whose centroid is nearest; ties stay, then go to the lower number.
uint32_t nearest_cluster(const Mesh& mesh, const Clusters& clusters, uint32_t v) {
  const uint32_t own = clusters.labels[v];
  uint32_t best = own;
  int64_t distance = -1;  // of `best`, once it is needed
  for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
    const uint32_t label = clusters.labels[mesh.col_indices[e]];
    if (label == own || label == best) continue;
    const Vec3i p = mesh.positions[v];
    if (distance < 0) {
      const Vec3i offset = p - clusters.centroids[own];
      distance = dot(offset, offset);
    }
    const Vec3i offset = p - clusters.centroids[label];
    const int64_t other = dot(offset, offset);
    if (other < distance || (other == distance && best != own && label < best)) {
      distance = other;
      best = label;
    }
  }
  return best;
}

}  // namespace

bool Clusters::allocate(Arena& arena, const Counts& counts, uint32_t most) {
  labels = arena.alloc<uint32_t>(counts.vertices);
  other = arena.alloc<uint32_t>(counts.vertices);
  sums = arena.alloc<Vec3l>(most);
  sizes = arena.alloc<uint32_t>(most);
  centroids = arena.alloc<Vec3i>(most);
  return arena.ok();
}

void find_clusters(const Mesh& mesh, uint32_t most, const Threads& threads, Clusters* clusters) {
  // Every part may have one cluster more than its share. Where that would leave too little to share, the largest
  // parts (they come first) divide half of the clusters, and the others are not divided further.
  const uint32_t quarter = most / 4;
  const bool crowded = mesh.part_count >= most - quarter;
  const uint32_t cut = crowded && quarter < mesh.part_count ? quarter : mesh.part_count;
  const uint32_t shared = crowded ? (quarter > 0 ? quarter : 1) : most - cut;
  const uint32_t vertices = mesh.part_offsets[cut];
  grow(mesh, cut, vertices == 0 ? 1 : (vertices + shared - 1) / shared, clusters);
  if (crowded) join_parts(mesh, cut, most - 2 * quarter, clusters);
  find_centroids(mesh, clusters);
  for (uint32_t round = 0; round < kLloydRounds; ++round) {
    threads.ranges(mesh.welded_count, kClusterPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
      for (uint32_t v = begin; v < end; ++v) clusters->other[v] = nearest_cluster(mesh, *clusters, v);
    });
    uint32_t* const before = clusters->labels;
    clusters->labels = clusters->other;
    clusters->other = before;
    find_centroids(mesh, clusters);
  }
}

}  // namespace sinew
