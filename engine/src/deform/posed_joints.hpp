// SPDX-License-Identifier: MIT
// The joints of a pose, and skinning with them in doubles: where a correction starts.
#ifndef SINEW_DEFORM_POSED_JOINTS_HPP
#define SINEW_DEFORM_POSED_JOINTS_HPP

#include "deform/dual_quaternion.hpp"
#include "deform/rest.hpp"

namespace sinew::deform {

struct PosedJoint {
  double matrix[12];       // row-major 3x4, the common scale divided out
  DualQuaternion motion;   // its quaternion lies on the parent's side
  DualQuaternion twisted;  // `motion` after all of the child's twist about the bone
  bool twists;             // this joint's bone takes a part of its one child's twist
  double overturned;  // 0..1: rotated by nearly 180 degrees against the parent, where dual quaternions change sides
  uint32_t group;     // the joint that this one moves with as one rigid piece: itself, or one above
};

struct PosedJoints {
  const DeformRest* rest = nullptr;
  PosedJoint* joints = nullptr;  // [J]
  double scale = 1;              // of all matrices
  bool overturned = false;       // one of the joints is
  bool rigid = false;            // false: the matrices are not rotations with one scale, and only `matrix` is filled

  bool allocate(Arena& arena, const DeformRest& of);
};

// Reads a palette [J x 12]. Quaternions go with their parent's along the hierarchy, so that two joints that rotated by more than
// 180 degrees against each other, through joints between them, blend as those do. Returns SINEW_OK or
// SINEW_ERROR_NOT_FINITE.
sinew_status read_palette(const float* palette, PosedJoints* posed);

// Whether joints move against each other.
bool bends(const PosedJoints& posed);
// Whether the joints of a row do not move as one rigid piece.
bool is_strained(const PosedJoints& posed, const WeightRow& row);

// Linear blending of rows of n influences. Exactly p where all matrices are the identity.
template <class Joint, class Weight>
Vec3d blend_linear(const PosedJoints& posed, const Joint* joints, const Weight* weights, uint32_t n, Vec3d p) {
  Vec3d sum = {0, 0, 0};
  double whole = 0;
  for (uint32_t i = 0; i < n; ++i) {
    if (weights[i] == 0) continue;
    const double* const m = posed.joints[joints[i]].matrix;
    const double w = weights[i];
    const Vec3d moved = {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
                         m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
    sum = sum + w * (moved - p);
    whole += w;
  }
  return whole > 0 ? p + (1 / whole) * sum : p;
}

// Share of its child's twist that a position on a joint's bone takes.
double twist_share(const RestJoint& joint, Vec3d position);
// Sum of the motions of a row at a position. A row without weights stands still.
DualQuaternion blend_motions(const PosedJoints& posed, const uint16_t* joints, const uint16_t* weights, uint32_t n,
                             Vec3d position);
// How far the joints of a row, by descending weight, are overturned against each other: the most of any joint between them.
double row_overturn(const PosedJoints& posed, const uint16_t* joints, const uint16_t* weights, uint32_t n);
// Dual quaternion blending: L. Kavan, S. Collins, J. Zara, C. O'Sullivan, ACM TOG 27(4), 2008. Overturned joints blend more
// and more linearly, so that nothing jumps where the quaternions change sides.
Vec3d blend_dual(const PosedJoints& posed, const uint16_t* joints, const uint16_t* weights, uint32_t n, Vec3d p);

}  // namespace sinew::deform
#endif
