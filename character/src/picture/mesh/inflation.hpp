// SPDX-License-Identifier: MIT
// How thick a silhouette is where: as round as it is wide.
#ifndef SINEW_CHARACTER_PICTURE_MESH_INFLATION_HPP
#define SINEW_CHARACTER_PICTURE_MESH_INFLATION_HPP

#include "picture/outline/raster.hpp"

namespace sinew::picture {

struct Inflation {
  Grid<float> depth;   // pixels to the outline, 0 outside
  Grid<float> height;  // pixels from the picture plane to the surface: that of all balls inside of the outline together
};
Inflation inflate(const Mask& mask);

}  // namespace sinew::picture
#endif
