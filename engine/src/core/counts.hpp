// SPDX-License-Identifier: MIT
// Upper bounds that every allocation of a bind is a function of.
#ifndef SINEW_CORE_COUNTS_HPP
#define SINEW_CORE_COUNTS_HPP

#include <stdint.h>

#include "core/build.hpp"
#include "core/threads.hpp"
#include "sinew/sinew.h"

namespace sinew {

constexpr uint16_t kNoJoint = 0xFFFF;
constexpr uint32_t kNoIndex = 0xFFFFFFFFu;  // no vertex, cell, row or the like

// Voxel cells along the longest side where `grid` is 0: 12 cells of the cube for a vertex of the surface, between these.
// Time and memory of the candidate search grow with the cube, the rest of a bind with the vertices. What more or fewer
// cells do to the candidates: trainer/configs/RESULTS.md.
constexpr uint32_t kFewestCells = 32, kMostCells = 64;
constexpr bool is_legal_grid(uint32_t grid) { return grid == 0 || (grid >= 16 && grid <= 128); }

// V, F, corners, J, K, the grid size and the lanes of one bind.
struct Counts {
  uint32_t vertices = 0;
  uint32_t faces = 0;
  uint32_t corners = 0;
  uint32_t joints = 0;
  uint32_t candidates = 8;
  uint32_t grid = 64;                      // voxel cells along the longest side; 0 = they follow the vertices
  uint32_t feature_flags = 0;              // optional channels, features/features.hpp
  uint32_t surface_vertices = UINT32_MAX;  // a mesh of more is reduced to as many
  Threads threads = {};                    // `lanes` is a bound like the others; the other members select how to run

  // Fan triangles T: a face of n corners gives n - 2, and none has fewer than two corners.
  uint32_t triangles() const { return corners - 2 * faces; }
  // Triangles above which a mesh is reduced, whatever its vertices: twice what a closed surface has.
  uint32_t surface_triangles() const { return surface_vertices > UINT32_MAX / 4 ? UINT32_MAX : 4 * surface_vertices; }
  // Whether the mesh may have to be reduced.
  bool may_reduce() const { return kHasExtras && (vertices > surface_vertices || triangles() > surface_triangles()); }
  // Voxel cells along the longest side for a surface of so many vertices. Never falls as they grow, so that the cells
  // for `vertices` bound those for the welded ones.
  uint32_t cells_along(uint32_t surface_size) const {
    if (grid != 0) return grid;
    uint32_t cells = kFewestCells;
    while (cells < kMostCells && (cells + 1) * (cells + 1) * (cells + 1) <= uint64_t{12} * surface_size) ++cells;
    return cells;
  }
  // Bounds of the mesh that the stages after the mesh run on: the reduced one, or the mesh itself.
  Counts surface() const {
    if (!may_reduce()) return *this;
    Counts counts = *this;
    if (vertices > surface_vertices) counts.vertices = surface_vertices;
    counts.faces = triangles() > surface_triangles() ? surface_triangles() : triangles();
    counts.corners = 3 * counts.faces;
    return counts;
  }
};

// Progress of one stage, in permille. What the stage reports, 0..1000, is mapped to [from, to] of the whole bind.
// report() returns false when the caller wants to stop.
struct Progress {
  static constexpr uint32_t kWhole = 1000;
  sinew_progress callback = nullptr;
  void* user = nullptr;
  uint32_t from = 0;
  uint32_t to = kWhole;

  bool report(uint32_t permille) const {
    return callback == nullptr || callback(user, from + permille * (to - from) / kWhole) == 0;
  }
  Progress part(uint32_t part_from, uint32_t part_to) const { return {callback, user, part_from, part_to}; }
};

}  // namespace sinew
#endif
