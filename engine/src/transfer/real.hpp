// SPDX-License-Identifier: MIT
// Doubles of the transfer stage: vectors, small matrices and a square root, each operation in one written order and none from a
// library, so that every target rounds the same.
#ifndef SINEW_TRANSFER_REAL_HPP
#define SINEW_TRANSFER_REAL_HPP

#include <stdint.h>
#include <string.h>

#include "core/fixed.hpp"

namespace sinew {

struct Vec3d {
  double x = 0, y = 0, z = 0;
};
inline Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3d operator*(double s, Vec3d a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3d cross(Vec3d a, Vec3d b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double abs_of(double v) { return v < 0 ? -v : v; }
inline double smaller(double a, double b) { return b < a ? b : a; }
inline double larger(double a, double b) { return b > a ? b : a; }
inline double clamped(double v, double low, double high) { return v < low ? low : v > high ? high : v; }

// 2^exponent for -1022 <= exponent <= 1023.
inline double power_of_two(int exponent) {
  const uint64_t bits = static_cast<uint64_t>(exponent + 1023) << 52;
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

// sqrt(v): 31 bits from the integer root, the rest by one Newton step; relative error below 2^-51. 0 for what is not above the
// smallest normal number. v is finite.
inline double root(double v) {
  uint64_t bits;
  memcpy(&bits, &v, sizeof bits);
  const int biased = static_cast<int>(bits >> 52);  // the sign makes it 2048 and more
  if (biased == 0 || biased > 2046) return 0;
  uint64_t mantissa = (bits & ((static_cast<uint64_t>(1) << 52) - 1)) | (static_cast<uint64_t>(1) << 52);
  int exponent = biased - 1023 - 52;  // v = mantissa * 2^exponent
  if ((exponent & 1) != 0) {
    mantissa <<= 1;
    --exponent;
  }
  const double guess = static_cast<double>(isqrt64(mantissa << 8)) * power_of_two(exponent / 2 - 4);
  return 0.5 * (guess + v / guess);
}

inline double length(Vec3d v) { return root(dot(v, v)); }
// v / |v|; the zero vector for what is shorter than 1e-150.
inline Vec3d unit(Vec3d v) {
  const double norm = length(v);
  return norm > 1e-150 ? Vec3d{v.x / norm, v.y / norm, v.z / norm} : Vec3d{};
}

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
  Mat3 turn;
  double scale = 1;
  Vec3d shift;
  Vec3d operator()(Vec3d x) const { return scale * (turn * x) + shift; }
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

}  // namespace sinew
#endif
