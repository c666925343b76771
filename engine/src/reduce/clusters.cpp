// SPDX-License-Identifier: MIT
// Seeds, breadth-first growth and Lloyd rounds over the one-ring.
#include "reduce/clusters.hpp"

#include "mesh/vector_math.hpp"

namespace sinew {
namespace {

constexpr uint32_t kUnseen = 0xFFFFFFFFu;
constexpr uint32_t kLloydRounds = 4;
constexpr uint32_t kVertexPiece = 1024;  // vertices that a lane takes at a time

// More components than clusters: runs of the Morton order, whatever they are connected to.
void cut_order(const Mesh& mesh, uint32_t most, Clusters* clusters) {
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    clusters->labels[v] = static_cast<uint32_t>(uint64_t{v} * most / mesh.welded_count);
  }
  clusters->count = most;
}

void grow(const Mesh& mesh, uint32_t step, Clusters* clusters) {
  uint32_t* const labels = clusters->labels;
  uint32_t* const queue = clusters->other;
  uint32_t tail = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) labels[v] = kUnseen;
  for (uint32_t c = 0; c < mesh.component_count; ++c) {
    for (uint32_t i = mesh.component_offsets[c]; i < mesh.component_offsets[c + 1]; i += step) {
      labels[mesh.component_vertices[i]] = tail;
      queue[tail++] = mesh.component_vertices[i];
    }
  }
  clusters->count = tail;
  for (uint32_t head = 0; head < tail; ++head) {
    const uint32_t v = queue[head];
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      const uint32_t neighbour = mesh.col_indices[e];
      if (labels[neighbour] != kUnseen) continue;
      labels[neighbour] = labels[v];
      queue[tail++] = neighbour;
    }
  }
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

// The cluster of the vertex or of a neighbour whose centroid is nearest; ties stay, then go to the lower number.
uint32_t nearest_cluster(const Mesh& mesh, const Clusters& clusters, uint32_t v) {
  const uint32_t own = clusters.labels[v];
  uint32_t best = own;
  int64_t distance = -1;  // of `best`, once it is needed
  for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
    const uint32_t label = clusters.labels[mesh.col_indices[e]];
    if (label == own || label == best) continue;
    const Vec3i p = mesh.positions[v];
    if (distance < 0) {
      const Vec3i way = p - clusters.centroids[own];
      distance = dot(way, way);
    }
    const Vec3i way = p - clusters.centroids[label];
    const int64_t other = dot(way, way);
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
  if (mesh.component_count > most / 2) {
    cut_order(mesh, most < mesh.welded_count ? most : mesh.welded_count, clusters);
    find_centroids(mesh, clusters);
    return;
  }
  // Every component may have one cluster more than its share.
  const uint32_t shared = most - mesh.component_count;
  grow(mesh, (mesh.welded_count + shared - 1) / shared, clusters);
  find_centroids(mesh, clusters);
  for (uint32_t round = 0; round < kLloydRounds; ++round) {
    threads.ranges(mesh.welded_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
      for (uint32_t v = begin; v < end; ++v) clusters->other[v] = nearest_cluster(mesh, *clusters, v);
    });
    uint32_t* const before = clusters->labels;
    clusters->labels = clusters->other;
    clusters->other = before;
    find_centroids(mesh, clusters);
  }
}

}  // namespace sinew
