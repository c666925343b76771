// SPDX-License-Identifier: MIT
// Geodesic voxel binding, a float peer for the benchmarks: Dionne and de Lasa, "Geodesic voxel binding for production
// character meshes", 2013.
#ifndef SINEW_TESTS_BENCH_GEODESIC_VOXEL_HPP
#define SINEW_TESTS_BENCH_GEODESIC_VOXEL_HPP

#include <cstdint>
#include <vector>

#include "sinew/sinew.h"

namespace sinew_bench {

struct GeodesicVoxelWeights {
  std::vector<uint16_t> joints;  // [V x 4] by falling weight
  std::vector<float> weights;    // [V x 4] sums to 1; all 0 where no joint is reached
};

// One shortest-path run per joint from the cells of its bones through the cells inside the body or on its surface,
// `cells` along the longest side (16..128); weight 1 / d^4 (falloff 1), the 4 largest. Empty when the mesh is refused.
GeodesicVoxelWeights bind_geodesic_voxel(const sinew_mesh& mesh, const sinew_skeleton& skeleton, uint32_t cells);

}  // namespace sinew_bench
#endif
