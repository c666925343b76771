// SPDX-License-Identifier: MIT
// A posed mesh made to look generated: one closed shell, what touches fused, what lies inside gone.
#ifndef SINEW_TRAINER_DATA_GROWN_SHELL_HPP
#define SINEW_TRAINER_DATA_GROWN_SHELL_HPP

#include <array>
#include <cstdint>
#include <vector>

namespace sinew {

struct GrownShell {
  std::vector<std::array<double, 3>> vertices;  // [S] units of the mesh
  std::vector<std::array<uint32_t, 3>>
      triangles;                 // counter-clockwise from outside; every edge has as many faces in one direction
                                 // as the other
  std::vector<uint32_t> source;  // [S] vertex of the mesh that is near
};

// Cells that the surface touches, `cells` along the longest side; gaps of one cell closed, what cannot be reached from outside
// filled; blurred (Gauss, 0.8 cells); its surface by nets (Gibson 1998, "Constrained elastic surface nets", without
// relaxation). Where two edges of a cell's boundary cross, more than two faces may meet at an edge.
//   vertices, triangles  a mesh with an extent
//   cells                at least 8
GrownShell grow_shell(const std::vector<std::array<double, 3>>& vertices,
                      const std::vector<std::array<uint32_t, 3>>& triangles, uint32_t cells);

}  // namespace sinew
#endif
