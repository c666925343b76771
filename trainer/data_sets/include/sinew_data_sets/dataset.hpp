// SPDX-License-Identifier: MIT
// Data set tooling on half-edge meshes (OpenMesh): checks and decimated variants.
#ifndef SINEW_DATA_SETS_DATASET_HPP
#define SINEW_DATA_SETS_DATASET_HPP

#include <string>
#include <vector>

#include "sinew_character/check/mesh_check.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// check_character(), with the number of loops in its note about boundary edges.
CheckReport check_training_character(const Character& character);

// Quadric decimation to about `ratio` (0..1] of the vertices; seams and boundaries kept, weights carried along (a
// surviving vertex keeps its own row). Vertices that end in no face are dropped. Throws Error when there are no faces.
Character decimate(const Character& character, double ratio);

// Every triangle, and every one of a polygon's fan, into four. Vertices stay, new ones follow them in the middle of the
// edges, with the mean of both ends' weights. Mesh, joints and weights alone; a mesh without faces stays as it is.
Character subdivide(const Character& character);

}  // namespace sinew
#endif
