// SPDX-License-Identifier: MIT
// Attributes as published for skin weights by graph convolutions, instead of the features: no heat weights among them.
#ifndef SINEW_FEATURES_ATTRIBUTES_HPP
#define SINEW_FEATURES_ATTRIBUTES_HPP

#include "features/features.hpp"

namespace sinew {

// Channels of a vertex, Q13, in the frame of the grid. The signatures of spectral/spectral.hpp lie behind them on demand.
enum VertexAttribute : uint32_t {
  kAttributePosition = 0,   // 3: twice the position, shares of the mesh's longest side
  kAttributeNormal = 3,     // 3
  kAttributeLaplacian = 6,  // 3: from the vertex to the mean of its neighbors, share of the mean length of its edges
  kAttributeCurvature = 9,  // 2: mean and Gaussian, of mesh/shape.hpp
  kVertexAttributes = 11
};
// Channels of a slot.
enum PairAttribute : uint32_t {
  kAttributeThrough = 0,   // twice the distance to the joint's bones through the body, as candidates are found
  kAttributeRatio = 1,     // log2 of it beside the nearest candidate's, a quarter
  kAttributeStraight = 2,  // twice the straight distance to the joint
  kPairAttributes = 3
};

// Fills everything but the spectral channels. Candidates are those of `candidates`, as they are. The room `published` defines it.
void build_attributes(const Mesh& mesh, const Skeleton& skeleton, const Candidates& candidates, Features* out);

}  // namespace sinew
#endif
