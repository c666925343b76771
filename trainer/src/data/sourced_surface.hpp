// SPDX-License-Identifier: MIT
// A surface whose vertices come from those of another, and what is made of it: double walls and specks, as files of strangers have
// them, or its silhouette as a mesh, as a picture shows it.
#ifndef SINEW_TRAINER_DATA_SOURCED_SURFACE_HPP
#define SINEW_TRAINER_DATA_SOURCED_SURFACE_HPP

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

// A second wall 0.004 to 0.02 inside, with opposite winding.
void add_wall(Random* random, SourcedSurface* surface);
// 10 to 80 tetrahedra of about 0.004, up to 0.03 away from a vertex, whose source they have.
void add_specks(Random* random, SourcedSurface* surface);

enum class SilhouetteView { kFromFront, kFromSide };

// The view that shows the greater extent.
SilhouetteView broad_view(const SourcedSurface& surface);

// What `sinew rig PICTURE` makes of the surface's outline (picture_mesh()), in the surface's frame: seen along z, or along x with its front to
// the right. Vertices before the picture's plane have the sources of what is seen, those behind it of what a look from the other side sees.
//   surface  x to the left, y up, z to the front; a mesh with an extent
//   pixels   along the longest side, at least 32
// Throws Error where too few pixels are covered.
SourcedSurface silhouette_of(const SourcedSurface& surface, SilhouetteView view, uint32_t pixels);

}  // namespace sinew
#endif
