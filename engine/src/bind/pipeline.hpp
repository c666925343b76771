// SPDX-License-Identifier: MIT
// All stages in order. sinew_bind() runs them to the end; the trainer stops after the features.
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

// Everything the stages before the network leave in the workspace.
struct Prepared {
  Mesh mesh;
  Skeleton skeleton;
  uint8_t* source_joints = nullptr;  // [J] of the heat stage
  Reduction reduction;
  Candidates candidates;
  HeatFields heat;
  Features features;  // candidates and features: not for kHeat

  // The mesh that the last three belong to.
  const Mesh& surface() const { return kHasExtras && reduction.active ? reduction.mesh : mesh; }
};

// How far to go: method heat needs neither candidates nor features. kNetworkAlone gives candidates and heat back, once
// the features are there, and puts those in their place.
enum class PrepareFor { kHeat, kNetwork, kNetworkAlone };

// Stages 1 and 2, and the skeleton on the same grid. Both are allocated; scratch is taken from the arena and released.
// Returns what make_grid_quantizer(), build_mesh() and build_skeleton() return, in this order.
sinew_status build_mesh_and_skeleton(const sinew_mesh& mesh_input, const sinew_skeleton& skeleton_input,
                                     uint32_t up_axis, const Counts& counts, Arena& arena, Mesh* mesh,
                                     Skeleton* skeleton);

// Runs stages 1 to 7, from the heat on over a reduced mesh if the mesh exceeds counts.surface() (and the spectral stage
// where counts.feature_flags ask for it) in the arena (for kHeat stages 1, 2 and 4). Reports 0..650 permille (kHeat:
// 0..950). `kernel` as in solve_heat().
sinew_status prepare(const sinew_mesh& mesh, const sinew_skeleton& skeleton, uint32_t up_axis, const Counts& counts,
                     PrepareFor purpose, const Progress& progress, Arena& arena, Prepared* out,
                     uint32_t kernel = SINEW_KERNEL_AUTO);
// Bytes prepare() needs, for a measuring arena. Leaves the arena at the mark where the network would start.
void measure_prepare(Arena& arena, const Counts& counts, PrepareFor purpose);
// What the network reads of them; the arrays stay where they are.
NetworkInput network_input(const Prepared& prepared, const Counts& counts);
// Checks the caller's counts against the limits and fills Counts. SINEW_ERROR_COUNT, SINEW_ERROR_ARGUMENT.
sinew_status make_counts(uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints, uint32_t candidates,
                         uint32_t grid, Counts* counts);

}  // namespace sinew
#endif
