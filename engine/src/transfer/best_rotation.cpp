// SPDX-License-Identifier: MIT
// Rotations from sums of vectors and from two directions, in doubles of one order.
#include "core/eigenpairs.hpp"
#include "transfer/align.hpp"

namespace sinew::transferring {

Mat3 best_rotation(const Mat3& sums, double* gap) {
  // m[i][j] = sum of v_i u_j; Horn's matrix has s_ij = sum of u_i v_j.
  const double* const m = sums.m;
  const double xx = m[0], xy = m[3], xz = m[6], yx = m[1], yy = m[4], yz = m[7], zx = m[2], zy = m[5], zz = m[8];
  double a[16] = {xx + yy + zz, yz - zy,      zx - xz,      xy - yx,        //
                  yz - zy,      xx - yy - zz, xy + yx,      zx + xz,        //
                  zx - xz,      xy + yx,      yy - xx - zz, yz + zy,        //
                  xy - yx,      zx + xz,      yz + zy,      zz - xx - yy};  //
  double vectors[16];
  find_eigenpairs(4, a, vectors);
  uint32_t best = 0;
  for (uint32_t i = 1; i < 4; ++i) best = a[5 * i] > a[5 * best] ? i : best;
  double second = -1e300;
  for (uint32_t i = 0; i < 4; ++i) second = i != best && a[5 * i] > second ? a[5 * i] : second;
  const double largest = a[5 * best];
  if (gap != nullptr) *gap = largest > 0 ? lesser((largest - second) / largest, 1) : 0;
  if (!(largest > 0)) return Mat3();
  return rotation(vectors[best], vectors[4 + best], vectors[8 + best], vectors[12 + best]);
}

Mat3 rotation_between(Vec3d from, Vec3d to) {
  const Vec3d u = unit(from), v = unit(to);
  // The quaternion (1 + u.v, u x v), which is twice cos and sin of half the angle.
  const double w = 1 + dot(u, v);
  Vec3d axis = cross(u, v);
  if (w < 1e-12) {
    axis = absolute(u.x) < 0.9 ? cross(u, {1, 0, 0}) : cross(u, {0, 1, 0});
    axis = unit(axis);
    return rotation(0, axis.x, axis.y, axis.z);
  }
  const double norm = root(w * w + dot(axis, axis));
  return rotation(w / norm, axis.x / norm, axis.y / norm, axis.z / norm);
}

}  // namespace sinew::transferring
