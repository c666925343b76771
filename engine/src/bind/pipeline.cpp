// SPDX-License-Identifier: MIT
// Runs the stages in front of the network.
#include "bind/pipeline.hpp"

#include <string.h>

#include "bind/progress.hpp"
#include "candidates/own_parts.hpp"
#include "features/attributes.hpp"
#include "heat/heat.hpp"
#include "spectral/spectral.hpp"

namespace sinew {
namespace {

// Moves all arrays by the same distance to the arena's current position, which is before theirs, the first one first.
void move_features(const Mesh& mesh, const Counts& counts, Arena& arena, Features* features) {
  const Features from = *features;
  (void)features->allocate(arena, counts);
  if (arena.measuring()) return;
  const size_t vertices = mesh.welded_count, pairs = vertices * counts.candidates;
  memmove(features->vertex, from.vertex, vertices * from.vertex_channels * sizeof(int16_t));
  memmove(features->pair, from.pair, pairs * pair_channels(counts.feature_flags) * sizeof(int16_t));
  memmove(features->joints, from.joints, pairs * sizeof(uint16_t));
}

// The network reads attributes as published, and no heat.
bool has_attributes(const Counts& counts) { return kHasExtras && (counts.feature_flags & kAttributesFlag) != 0; }

// The search's voxels are most of the workspace of a small mesh: nothing but the mesh is beside them.
sinew_status find_candidates_then_heat(const Mesh& mesh, const Counts& surface, PreparePurpose purpose,
                                       const Kernels& kernels, const Progress& progress, Arena& arena,
                                       PreparedBind* out) {
  const bool network = purpose != PreparePurpose::kHeat;
  if (network) {
    if (!out->candidates.allocate(arena, surface)) return SINEW_ERROR_WORKSPACE;
    const sinew_status status =
        find_candidates(mesh, out->skeleton, surface, progress.part(ends_at::kReduction, ends_at::kCandidates), arena,
                        &out->candidates);
    if (status != SINEW_OK) return status;
  }
  if (purpose == PreparePurpose::kNetworkAlone && has_attributes(surface)) return SINEW_OK;
  if (!out->heat.allocate(arena, surface)) return SINEW_ERROR_WORKSPACE;
  const Progress heat_progress = network ? progress.part(ends_at::kCandidates, ends_at::kHeat)
                                         : progress.part(ends_at::kReduction, ends_at::kHeatAlone);
  return solve_heat(mesh, out->skeleton, out->source_joints, surface, kernels, heat_progress, arena, &out->heat);
}

// With threads the search, which is one queue, goes on while heat factorises, which has few pieces: more memory, less
// time.
sinew_status find_candidates_beside_heat(const Mesh& mesh, const Counts& surface, const Kernels& kernels,
                                         const Progress& progress, Arena& arena, PreparedBind* out) {
  (void)out->candidates.allocate(arena, surface);
  if (!out->heat.allocate(arena, surface)) return SINEW_ERROR_WORKSPACE;
  const ArenaScope scope(arena);
  CandidateSearch search;
  if (!search.allocate(arena, surface)) return SINEW_ERROR_WORKSPACE;
  struct Job {
    CandidateSearch& search;
    const Mesh& mesh;
    PreparedBind& out;
    Counts counts;
  } job = {search, mesh, *out, surface};
  job.counts.threads = Threads();
  const WorkBeside beside = {[](void* data) {
                               Job& own = *static_cast<Job*>(data);
                               (void)own.search.run(own.mesh, own.out.skeleton, own.counts, {}, &own.out.candidates);
                             },
                             &job};
  const sinew_status status = solve_heat(mesh, out->skeleton, out->source_joints, surface, kernels,
                                         progress.part(ends_at::kReduction, ends_at::kHeat), arena, &out->heat, beside);
  if (status == SINEW_OK && !arena.measuring()) search.write(mesh, surface.threads, &out->candidates);
  return status;
}

}  // namespace

NetworkInput largest_network_input(const Counts& counts) {
  NetworkInput input;
  input.vertex_count = counts.vertices;
  input.candidate_count = counts.candidates;
  input.joint_count = counts.joints;
  input.threads = counts.threads;
  return input;
}

NetworkInput network_input(const PreparedBind& p, const Counts& counts) {
  NetworkInput input = largest_network_input(counts);
  const Mesh& mesh = p.surface();
  input.vertex_count = mesh.welded_count;
  input.inputs[kVertexInput] = p.features.vertex;
  input.inputs[kPairInput] = p.features.pair;
  input.joints = p.features.joints;
  input.row_offsets = mesh.row_offsets;
  input.col_indices = mesh.col_indices;
  input.part = mesh.part;
  input.part_offsets = mesh.part_offsets;
  input.part_vertices = mesh.part_vertices;
  input.part_count = mesh.part_count;
  input.joint_count = p.skeleton.joint_count;
  return input;
}

sinew_status make_counts(uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints, uint32_t candidates,
                         uint32_t grid, Counts* counts) {
  if (vertices == 0 || vertices > SINEW_MAX_VERTICES || joints == 0 || joints > SINEW_MAX_JOINTS)
    return SINEW_ERROR_COUNT;
  // A vertex of a closed triangle mesh has about six corners; sixteen times that is not a mesh.
  if (corners > 24u * SINEW_MAX_VERTICES || faces > corners / 2) return SINEW_ERROR_COUNT;
  if (candidates < 1 || candidates > SINEW_MAX_CANDIDATES || !is_legal_grid(grid)) return SINEW_ERROR_ARGUMENT;
  *counts = Counts{vertices, faces, corners, joints, candidates, grid};
  return SINEW_OK;
}

sinew_status build_mesh_and_skeleton(const sinew_mesh& mesh_input, const sinew_skeleton& skeleton_input,
                                     uint32_t up_axis, const Counts& counts, Arena& arena, Mesh* mesh,
                                     Skeleton* skeleton) {
  GridQuantizer quantizer;
  sinew_status status = SINEW_OK;
  if (!arena.measuring())
    status = make_grid_quantizer(mesh_input.positions, mesh_input.vertex_count, up_axis, &quantizer);
  if (status == SINEW_OK) status = build_mesh(mesh_input, quantizer, counts, arena, mesh);
  if (status == SINEW_OK && !arena.measuring()) status = build_skeleton(skeleton_input, quantizer, skeleton);
  return status;
}

sinew_status prepare(const sinew_mesh& mesh, const sinew_skeleton& skeleton, uint32_t up_axis, const Counts& counts,
                     PreparePurpose purpose, const Kernels& kernels, const Progress& progress, Arena& arena,
                     PreparedBind* out) {
  (void)out->mesh.allocate(arena, counts);
  (void)out->skeleton.allocate(arena, counts);
  out->source_joints = arena.alloc<uint8_t>(counts.joints);
  out->part_owners = arena.alloc<uint16_t>(counts.vertices);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  sinew_status status = build_mesh_and_skeleton(mesh, skeleton, up_axis, counts, arena, &out->mesh, &out->skeleton);
  if (status == SINEW_OK) status = find_own_parts(out->mesh, counts, arena, &out->skeleton, out->part_owners);
  if (status != SINEW_OK) return status;
  if (!arena.measuring()) choose_source_joints(out->mesh, out->skeleton, out->source_joints);
  if (!progress.report(ends_at::kMesh)) return SINEW_ERROR_CANCELLED;

  if (counts.may_reduce()) {
    if (!out->reduction.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
    status = reduce_mesh(out->mesh, counts, progress.part(ends_at::kMesh, ends_at::kReduction), arena, &out->reduction);
    if (status != SINEW_OK) return status;
  }
  const Counts surface = counts.surface();
  const Mesh& mesh_of_stages = out->surface();

  if constexpr (kHasExtras) {
    if (purpose == PreparePurpose::kDistance) {
      if (!out->heat.allocate(arena, surface)) return SINEW_ERROR_WORKSPACE;
      status = weigh_by_distance(mesh_of_stages, out->skeleton, out->source_joints, surface, arena, &out->heat);
      if (status != SINEW_OK) return status;
      return progress.report(ends_at::kHeatAlone) ? SINEW_OK : SINEW_ERROR_CANCELLED;
    }
  }
  const bool network = purpose != PreparePurpose::kHeat;
  const size_t mark = arena.mark();
  if (network && kHasThreads && !has_attributes(surface) && surface.threads.lanes > 1) {
    status = find_candidates_beside_heat(mesh_of_stages, surface, kernels, progress, arena, out);
  } else {
    status = find_candidates_then_heat(mesh_of_stages, surface, purpose, kernels, progress, arena, out);
  }
  if (status != SINEW_OK || !network) return status;

  if (!out->features.allocate(arena, surface)) return SINEW_ERROR_WORKSPACE;
  if (has_attributes(surface)) {
    if constexpr (kHasExtras) {
      if (!arena.measuring()) build_attributes(mesh_of_stages, out->skeleton, out->candidates, &out->features);
    }
  } else {
    status = build_features(mesh_of_stages, out->skeleton, out->candidates, out->heat, surface, arena, &out->features);
  }
  if (status != SINEW_OK) return status;
  if ((counts.feature_flags & kFeatureFlags & kSpectralFlag) != 0) {
    // Their channels lie behind the others of a vertex.
    int16_t* const spectral =
        arena.measuring() ? nullptr : out->features.vertex + plain_vertex_channels(counts.feature_flags);
    status = compute_spectral(mesh_of_stages, surface, progress.part(ends_at::kFeatures, ends_at::kSpectral), arena,
                              spectral, out->features.vertex_channels);
    if (status != SINEW_OK) return status;
  }
  if (purpose == PreparePurpose::kNetworkAlone) {
    arena.release(mark);
    move_features(mesh_of_stages, surface, arena, &out->features);
    out->candidates = Candidates();
    out->heat = HeatFields();
  }
  return progress.report(ends_at::kSpectral) ? SINEW_OK : SINEW_ERROR_CANCELLED;
}

}  // namespace sinew
