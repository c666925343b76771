// SPDX-License-Identifier: MIT
// The spectral stage: part by part eigenpairs, then signatures.
#include "spectral/spectral.hpp"

#include "spectral/eigenpairs.hpp"
#include "spectral/signatures.hpp"

namespace sinew {
namespace {

struct SpectralScratch {
  SpectralOperator op;
  EigenSolver solver;
  Signatures* signatures = nullptr;

  bool allocate(Arena& arena, const Counts& counts) {
    op.allocate(arena, counts);
    solver.allocate(arena, counts);
    signatures = arena.alloc<Signatures>(1);
    return arena.ok();
  }
};

}  // namespace

sinew_status compute_spectral(const Mesh& mesh, const Counts& counts, const Progress& progress, Arena& arena,
                              int16_t* out, size_t stride) {
  const ArenaScope scope(arena);
  SpectralScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  sum_cotangents(mesh, &scratch.op.edges);
  uint64_t done = 0;
  for (uint32_t c = 0; c < mesh.part_count; ++c) {
    Eigenpairs pairs;
    const uint32_t size = mesh.part_sizes[c];
    const bool solved = size > 1 && scratch.solver.solve(mesh, scratch.op, c, &pairs);
    scratch.signatures->prepare(pairs);
    for (uint32_t i = 0; i < size; ++i) {
      const uint32_t v = mesh.part_vertices[mesh.part_offsets[c] + i];
      int32_t vector[kSpectralModes] = {};
      if (solved) scratch.solver.row(v, vector);
      scratch.signatures->write(vector, out + v * stride);
    }
    done += size;
    if (!progress.report(static_cast<uint32_t>(done * 1000 / mesh.welded_count))) return SINEW_ERROR_CANCELLED;
  }
  return SINEW_OK;
}

}  // namespace sinew
