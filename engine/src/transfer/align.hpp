// SPDX-License-Identifier: MIT
// Brings the source's surface to the target by the two skeletons.
#ifndef SINEW_TRANSFER_ALIGN_HPP
#define SINEW_TRANSFER_ALIGN_HPP

#include "transfer/joint_counterparts.hpp"
#include "transfer/real.hpp"
#include "weights/rows.hpp"

namespace sinew::transferring {

// Positions in longest sides of a mesh: its own grid over 2^20.
inline Vec3d position_of(Vec3i grid) {
  constexpr double kUnit = 1.0 / kSide;
  return {grid.x * kUnit, grid.y * kUnit, grid.z * kUnit};
}

struct Alignment {
  Similarity* joints = nullptr;  // [source joints] the source's space to the target's
  double scale = 1;              // of the whole skeleton

  bool allocate(Arena& arena, uint32_t source_joints);
  // Turns and scales every bone of the source onto its counterpart, from the roots on. A joint with one mapped bone below
  // rotates by the smallest rotation, one with several by the one that fits them best, one with none as its parent. A
  // skeleton that faces elsewhere is rotated as a whole first. Without mapped joints the boxes are matched.
  //   scratch  [source joints x 3 + 1]
  void find(const JointCounterparts& map, const Skeleton& source, const Skeleton& target, uint32_t* scratch);
  // Where linear blend skinning with the source's own weights brings a point of the source.
  Vec3d warp(Vec3d point, const uint16_t* row_joints, const uint32_t* row_weights) const;
};

// The rotation R that makes the sum of v . (R u) largest (Horn 1987).
//   sums  row-major sum of v u^T
//   gap   out, when not null: by how much the best is better than the second, 0..1; near 0 the vectors lie on a line
Mat3 best_rotation(const Mat3& sums, double* gap);
// The smallest rotation of u to v's direction; any axis for 180 degrees.
Mat3 rotation_between(Vec3d u, Vec3d v);

}  // namespace sinew::transferring
#endif
