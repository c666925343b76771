// SPDX-License-Identifier: MIT
// What files of strangers have beside their surface: walls that are double, specks.
#ifndef SINEW_TRAINER_DATA_ROUGH_SURFACE_HPP
#define SINEW_TRAINER_DATA_ROUGH_SURFACE_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "core/random.hpp"

namespace sinew {

// A surface whose vertices come from those of another.
struct SourcedSurface {
  std::vector<std::array<double, 3>> vertices;     // [V] shares of the longest side
  std::vector<std::array<uint32_t, 3>> triangles;  // [T]
  std::vector<uint32_t> source;                    // [V]
};

// A second wall 0.004 to 0.02 inside, wound the other way.
void add_wall(Random* random, SourcedSurface* surface);
// 10 to 80 tetrahedra of about 0.004, up to 0.03 away from a vertex, whose source they have.
void add_specks(Random* random, SourcedSurface* surface);

}  // namespace sinew
#endif
