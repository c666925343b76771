// SPDX-License-Identifier: MIT
// Quaternions and dual quaternions of poses in doubles: products and sums of one order, and no library call, so that they are
// the same on every target.
#ifndef SINEW_DEFORM_DUAL_QUATERNION_HPP
#define SINEW_DEFORM_DUAL_QUATERNION_HPP

#include "core/vec3d.hpp"
#include "deform/rotation_quaternion.hpp"

namespace sinew::deform {

using Quaternion = QuaternionOf<double>;
inline Quaternion operator*(double s, const Quaternion& q) { return {s * q.w, s * q.x, s * q.y, s * q.z}; }
inline Quaternion operator+(const Quaternion& a, const Quaternion& b) {
  return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
}
inline double dot(const Quaternion& a, const Quaternion& b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }
inline Quaternion conjugate(const Quaternion& q) { return {q.w, -q.x, -q.y, -q.z}; }
inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
// p + 2 v x (v x p + w p): exactly p for the unit quaternion (w, 0, 0, 0).
inline Vec3d rotate(const Quaternion& q, Vec3d p) {
  const Vec3d v = {q.x, q.y, q.z};
  return p + 2.0 * cross(v, cross(v, p) + q.w * p);
}

// Unit quaternion of a rotation, row-major 3x4.
inline Quaternion rotation_quaternion(const double* m) {
  const Quaternion q = long_rotation_quaternion(m);
  return reciprocal_root(dot(q, q)) * q;
}

// A rigid motion: rotation, and half the translation times the rotation.
struct DualQuaternion {
  Quaternion real, dual;
};
inline DualQuaternion motion(const Quaternion& rotation, Vec3d translation) {
  return {rotation, 0.5 * (Quaternion{0, translation.x, translation.y, translation.z} * rotation)};
}
inline DualQuaternion operator*(const DualQuaternion& a, const DualQuaternion& b) {
  return {a.real * b.real, a.real * b.dual + a.dual * b.real};
}
inline void add_scaled(DualQuaternion* sum, double s, const DualQuaternion& q) {
  sum->real = sum->real + s * q.real;
  sum->dual = sum->dual + s * q.dual;
}
// Moves a point by a sum of motions, normalized. Exactly p for sums of the identity.
inline Vec3d move(const DualQuaternion& sum, Vec3d p) {
  const double inverse = reciprocal_root(dot(sum.real, sum.real));
  const Quaternion real = inverse * sum.real, dual = inverse * sum.dual;
  const Quaternion t = dual * conjugate(real);
  return rotate(real, p) + 2.0 * Vec3d{t.x, t.y, t.z};
}

}  // namespace sinew::deform
#endif
