// SPDX-License-Identifier: MIT
// The stages of a bind in front of the network: from the caller's mesh to candidates, heat fields and features.
// run_bind() goes on from there to the caller's rows. The trainer stops there and learns from the features.
#ifndef SINEW_BIND_PIPELINE_HPP
#define SINEW_BIND_PIPELINE_HPP

#include "candidates/candidates.hpp"
#include "features/features.hpp"
#include "heat/heat.hpp"
#include "mesh/mesh.hpp"
#include "network/network.hpp"
#include "reduce/reduction.hpp"
#include "skeleton/skeleton.hpp"

namespace sinew {

// Results of the stages in the workspace, in their order.
struct PreparedBind {
  Mesh mesh;
  Skeleton skeleton;
  uint8_t* source_joints = nullptr;  // [J] of the heat stage
  uint16_t* part_owners = nullptr;   // [parts of `mesh`] the joint whose the part is alone, or kNoJoint
  Reduction reduction;
  Candidates candidates;
  HeatFields heat;
  Features features;

  // The mesh that candidates, heat and features have rows for: the reduced one if the mesh was reduced.
  const Mesh& surface() const { return kHasExtras && reduction.active ? reduction.mesh : mesh; }
};

// Purposes of prepare().
enum class PreparePurpose {
  kHeat,          // rows from the heat field: there are neither candidates nor features
  kDistance,      // the same, but with weights by distance instead of the network
  kNetwork,       // the network and readers of candidates and heat: everything is there
  kNetworkAlone,  // only the network: candidates and heat are released, and features use their memory
};

// Stages 1 and 2, and the skeleton on the same grid. Both are allocated; scratch is taken from the arena and released.
// Returns what make_grid_quantizer(), build_mesh() and build_skeleton() return, in this order.
sinew_status build_mesh_and_skeleton(const sinew_mesh& mesh_input, const sinew_skeleton& skeleton_input,
                                     uint32_t up_axis, const Counts& counts, Arena& arena, Mesh* mesh,
                                     Skeleton* skeleton);

// Runs the stages that the purpose needs. They run on the reduced mesh from the candidates on if the mesh exceeds what
// counts.surface() bounds. Features include the spectral ones if counts.feature_flags ask for them.
//   mesh, skeleton  the caller's; not read with a measuring arena
//   up_axis         0 = Y is up, 1 = Z
//   progress        reported up to ends_at::kSpectral, for kHeat up to ends_at::kHeatAlone
//   arena           holds what `out` points to; scratch is released
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE, SINEW_ERROR_CANCELLED, or what build_mesh_and_skeleton() refuses.
sinew_status prepare(const sinew_mesh& mesh, const sinew_skeleton& skeleton, uint32_t up_axis, const Counts& counts,
                     PreparePurpose purpose, const Kernels& kernels, const Progress& progress, Arena& arena,
                     PreparedBind* out);

// Views of what the network reads. The arrays stay where they are.
NetworkInput network_input(const PreparedBind& prepared, const Counts& counts);
// The counts of the largest input that prepare() can leave for these counts, without arrays: for a measuring arena.
NetworkInput largest_network_input(const Counts& counts);

// Checks the caller's counts against the limits of sinew.h and fills Counts with them. SINEW_ERROR_COUNT,
// SINEW_ERROR_ARGUMENT.
sinew_status make_counts(uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints, uint32_t candidates,
                         uint32_t grid, Counts* counts);

}  // namespace sinew
#endif
