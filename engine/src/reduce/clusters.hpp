// SPDX-License-Identifier: MIT
// Cuts the vertices of a mesh into connected clusters of about the same number.
#ifndef SINEW_REDUCE_CLUSTERS_HPP
#define SINEW_REDUCE_CLUSTERS_HPP

#include "mesh/mesh.hpp"

namespace sinew {

struct Clusters {
  uint32_t count = 0;          // some may be empty
  uint32_t* labels = nullptr;  // [U] cluster of each vertex
  uint32_t* other = nullptr;   // [U] scratch
  Vec3l* sums = nullptr;       // [most] of the positions
  uint32_t* sizes = nullptr;   // [most] vertices
  Vec3i* centroids = nullptr;  // [most] rounded means, undefined for an empty cluster

  bool allocate(Arena& arena, const Counts& counts, uint32_t most);
};

// At most `most` >= 1 clusters: seeds at equal steps through the Morton order of every part, grown breadth first,
// then a few rounds of Lloyd's algorithm (1982) in which a vertex may go over to a neighbor's cluster whose centroid
// is nearer. Of more parts than three quarters of `most` the smallest become a cluster each or, neighbors in
// Morton order together, share one. A function of the mesh alone, for any number of threads.
void find_clusters(const Mesh& mesh, uint32_t most, const Threads& threads, Clusters* clusters);

}  // namespace sinew
#endif
