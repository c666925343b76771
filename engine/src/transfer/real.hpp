// SPDX-License-Identifier: MIT
// Doubles of the transfer stage: small matrices, each operation in one written order and none from a
// library, so that every target rounds the same.
#ifndef SINEW_TRANSFER_REAL_HPP
#define SINEW_TRANSFER_REAL_HPP

#include <stdint.h>
#include <string.h>

#include "core/vec3d.hpp"

namespace sinew::transferring {

// Row-major 3 x 3.
struct Mat3 {
  double m[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
};
inline Vec3d operator*(const Mat3& a, Vec3d v) {
  return {a.m[0] * v.x + a.m[1] * v.y + a.m[2] * v.z, a.m[3] * v.x + a.m[4] * v.y + a.m[5] * v.z,
          a.m[6] * v.x + a.m[7] * v.y + a.m[8] * v.z};
}
inline Mat3 operator*(const Mat3& a, const Mat3& b) {
  Mat3 out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      out.m[3 * i + j] = a.m[3 * i] * b.m[j] + a.m[3 * i + 1] * b.m[3 + j] + a.m[3 * i + 2] * b.m[6 + j];
  return out;
}

// x -> scale turn x + shift.
struct Similarity {
  Mat3 rotation;
  double scale = 1;
  Vec3d shift;
  Vec3d operator()(Vec3d x) const { return scale * (rotation * x) + shift; }
};

// The rotation by (w, x, y, z), a unit quaternion.
inline Mat3 rotation(double w, double x, double y, double z) {
  Mat3 r;
  r.m[0] = 1 - 2 * (y * y + z * z);
  r.m[1] = 2 * (x * y - w * z);
  r.m[2] = 2 * (x * z + w * y);
  r.m[3] = 2 * (x * y + w * z);
  r.m[4] = 1 - 2 * (x * x + z * z);
  r.m[5] = 2 * (y * z - w * x);
  r.m[6] = 2 * (x * z - w * y);
  r.m[7] = 2 * (y * z + w * x);
  r.m[8] = 1 - 2 * (x * x + y * y);
  return r;
}

}  // namespace sinew::transferring
#endif
