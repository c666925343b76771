// SPDX-License-Identifier: MIT
// The surface that moves with each joint: how much of it, and where its middle is.
#ifndef SINEW_CHARACTER_RIG_JOINT_SURFACES_HPP
#define SINEW_CHARACTER_RIG_JOINT_SURFACES_HPP

#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct JointSurfaces {
  std::vector<float> shares;     // [J] of the whole
  std::vector<float> centroids;  // [J x 3] the joint's position where nothing moves with it
};

// Vertices are the samples, each as large as a third of the triangles around it; all alike where there is no surface, as in a
// rig.txt without its mesh. Empty without weights.
JointSurfaces joint_surfaces(const Character& character);

}  // namespace sinew
#endif
