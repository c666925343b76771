// SPDX-License-Identifier: MIT
// Quaternions of rotation matrices, in floats for skinning alone and in doubles for corrected poses.
#ifndef SINEW_DEFORM_ROTATION_QUATERNION_HPP
#define SINEW_DEFORM_ROTATION_QUATERNION_HPP

namespace sinew::deform {

template <class Real>
struct QuaternionOf {
  Real w, x, y, z;
};

// The quaternion of a rotation, row-major 3x4, not normalized (Shepperd 1978): of the four squares 4w^2, 4x^2, 4y^2,
// 4z^2 the largest is at least 1, so the division by the length is well conditioned.
template <class Real>
QuaternionOf<Real> long_rotation_quaternion(const Real* m) {
  const Real xx = m[0], yy = m[5], zz = m[10];
  const Real w2 = 1 + xx + yy + zz, x2 = 1 + xx - yy - zz, y2 = 1 - xx + yy - zz, z2 = 1 - xx - yy + zz;
  if (w2 >= x2 && w2 >= y2 && w2 >= z2) return {w2, m[9] - m[6], m[2] - m[8], m[4] - m[1]};
  if (x2 >= y2 && x2 >= z2) return {m[9] - m[6], x2, m[4] + m[1], m[2] + m[8]};
  if (y2 >= z2) return {m[2] - m[8], m[4] + m[1], y2, m[9] + m[6]};
  return {m[4] - m[1], m[2] + m[8], m[9] + m[6], z2};
}

}  // namespace sinew::deform
#endif
