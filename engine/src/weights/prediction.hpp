// SPDX-License-Identifier: MIT
// Input of rows: logits of a network or a heat field of the surface, and how a row of the caller's welded
// mesh comes from rows of the surface.
#ifndef SINEW_WEIGHTS_PREDICTION_HPP
#define SINEW_WEIGHTS_PREDICTION_HPP

#include "core/build.hpp"
#include "heat/heat.hpp"
#include "kernels/softmax.hpp"
#include "mesh/mesh.hpp"
#include "reduce/reduction.hpp"
#include "weights/blend.hpp"

namespace sinew {

struct Prediction {
  const Mesh& mesh;            // the caller's, welded
  const Mesh& surface;         // the reduced mesh if there is one, else `mesh`
  const Reduction& reduction;  // from one to the other
  const Skeleton& skeleton;    // on the same grid
  const HeatField& heat;       // rows come from it if there are no logits
  const int16_t* logits;       // [U x K] log2 units Q10, or null
  const uint16_t* joints;      // [U x K] the joint of each logit
  uint32_t candidates;         // K
  SoftmaxKernel softmax;
  const sinew_model* model;          // the one that the logits are from, for its table of confidence; or null
  const uint16_t* owners = nullptr;  // [parts of mesh] the joint that is the row of the part's vertices, or kNoJoint
};

// The row of a welded vertex of the full mesh, from those that row(surface vertex, joints, weights) gives.
//   joints, weights  out [kRowSlots]
template <class Row>
void full_row(const Prediction& p, uint32_t vertex, const Row& row, uint16_t* joints, uint32_t* weights) {
  if (!kHasExtras || !p.reduction.active) return row(vertex, joints, weights);
  const SurfacePosition position = p.reduction.position(p.mesh, vertex);
  RowBlend blend;
  for (int i = 0; i < 3; ++i) {
    if (position.shares[i] == 0) continue;
    row(position.vertices[i], joints, weights);
    blend.add(joints, weights, position.shares[i]);
  }
  blend.take(joints, weights);
}

// The finished heat row of a vertex of the surface. joints, weights: out [kRowSlots], unused slots kNoJoint and 0.
inline void heat_row(const HeatField& heat, uint32_t vertex, uint16_t* joints, uint32_t* weights) {
  uint16_t row_weights[kHeatSlots];
  const uint32_t count = finish_heat_row(heat, vertex, joints, row_weights);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (i >= count) joints[i] = kNoJoint;
    weights[i] = i < count ? 2u * row_weights[i] : 0;
  }
}

}  // namespace sinew
#endif
