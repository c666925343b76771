// SPDX-License-Identifier: MIT
// A rest at the begin of the caller's memory, and a pose of it by its method.
#include <string.h>

#include "deform/correction.hpp"
#include "deform/rest.hpp"
#include "kernels/select.hpp"
#include "sinew/published.h"

namespace sinew::deform {
namespace {

// With a measuring arena only takes memory.
sinew_status run_pose(const DeformRest& rest, const float* palette, Arena& arena, sinew_deform_outputs* outputs) {
  PosedJoints posed;
  (void)posed.allocate(arena, rest);
  Vec3d* const positions = arena.alloc<Vec3d>(rest.vertex_count);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  sinew_status status = SINEW_OK;
  PoseCounts counts;
  if (!arena.measuring()) status = read_palette(palette, &posed);
  if (status != SINEW_OK) return status;
  const uint32_t n = rest.influence_count;
  if (arena.measuring() || posed.rigid) {
    if (rest.options.method == SINEW_DEFORM_VOLUME) status = pose_volume(posed, arena, positions, &counts);
    if (rest.options.method == SINEW_DEFORM_XPBD) status = pose_published(posed, arena, positions, &counts);
    if (rest.options.method == SINEW_DEFORM_DELTA_MUSH) status = pose_delta_mush(posed, arena, positions);
    if (status != SINEW_OK || arena.measuring()) return status;
  } else {
    for (uint32_t v = 0; v < rest.vertex_count; ++v) {
      const size_t at = static_cast<size_t>(v) * n;
      positions[v] = blend_linear(posed, rest.joints + at, rest.weights + at, n, rest.position(v));
    }
  }
  for (uint32_t v = 0; v < rest.vertex_count; ++v) {
    float* const out = outputs->positions + 3 * static_cast<size_t>(v);
    out[0] = static_cast<float>(posed.scale * positions[v].x);
    out[1] = static_cast<float>(posed.scale * positions[v].y);
    out[2] = static_cast<float>(posed.scale * positions[v].z);
  }
  outputs->corrected = posed.rigid ? 1 : 0;
  outputs->active_tetrahedra = counts.active_tetrahedra;
  outputs->inverted_tetrahedra = counts.inverted_tetrahedra;
  return SINEW_OK;
}

}  // namespace

sinew_status create_deformer(const RestInput& input, Arena& arena, sinew_deformer* deformer) {
  DeformRest* const home = arena.alloc<DeformRest>(1);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  DeformRest rest;
  const sinew_status status = build_rest(input, arena, &rest);
  if (status != SINEW_OK || arena.measuring()) return status;
  const Cpu cpu = detect_cpu();
  if (cpu.avx2) (void)add_constraints_s32_avx2(&rest.kernels);
  if (cpu.vnni) (void)add_constraints_s32_avx512(&rest.kernels);
  *home = rest;
  Arena measuring;
  (void)run_pose(rest, nullptr, measuring, nullptr);
  memset(deformer, 0, sizeof *deformer);
  deformer->memory = home;
  deformer->pose_bytes = measuring.high_water();
  deformer->vertex_count = rest.vertex_count;
  deformer->joint_count = rest.joint_count;
  deformer->tetrahedron_count = rest.lattice.tetrahedron_count;
  deformer->node_count = rest.lattice.node_count;
  deformer->split_cell_count = rest.lattice.split_cells;
  return SINEW_OK;
}

sinew_status pose_deformer(const DeformRest& rest, const float* palette, Arena& arena, sinew_deform_outputs* outputs) {
  return run_pose(rest, palette, arena, outputs);
}

}  // namespace sinew::deform
