// SPDX-License-Identifier: MIT
// Vectors of doubles. Every operation rounds by itself (no contraction), so results are the same on every target.
#ifndef SINEW_CORE_VEC3D_HPP
#define SINEW_CORE_VEC3D_HPP

#include "core/fixed.hpp"

namespace sinew {

struct Vec3d {
  double x, y, z;
};
inline Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3d operator*(double s, Vec3d a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3d cross(Vec3d a, Vec3d b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Vec3d to_double(Vec3i v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace sinew
#endif
