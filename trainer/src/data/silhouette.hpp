// SPDX-License-Identifier: MIT
// A surface as a picture shows it: its silhouette, made a mesh as pictures are.
#ifndef SINEW_TRAINER_DATA_SILHOUETTE_HPP
#define SINEW_TRAINER_DATA_SILHOUETTE_HPP

#include <cstdint>

#include "data/rough_surface.hpp"

namespace sinew {

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
