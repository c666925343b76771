// SPDX-License-Identifier: MIT
// Doubles, vectors of them and their lengths: each operation in one written order, rounded by itself (no contraction), and none from
// a library, so that every target has the same bits.
#ifndef SINEW_CORE_VEC3D_HPP
#define SINEW_CORE_VEC3D_HPP

#include <string.h>

#include "core/fixed.hpp"

namespace sinew {

inline double absolute(double a) { return a < 0 ? -a : a; }
inline double lesser(double a, double b) { return b < a ? b : a; }
inline double greater(double a, double b) { return a < b ? b : a; }
inline double clamped(double a, double low, double high) { return a < low ? low : a > high ? high : a; }
// From 0 at `from` to 1 at `to`, without a corner.
inline double ramp(double x, double from, double to) {
  const double share = (x - from) / (to - from);
  return share <= 0 ? 0 : share >= 1 ? 1 : share * share * (3 - 2 * share);
}

// cos and sin of -180..180 degrees by their series, of half the angle: the last term is below the last bit.
SINEW_ONCE inline void cosine_and_sine(double degrees, double* cosine, double* sine) {
  constexpr double kHalfDegree = 0.00872664625997165;  // pi / 360
  const double x = kHalfDegree * degrees, square = x * x;
  double c = 1, s = x, cosine_term = 1, sine_term = x;
  for (int k = 1; k < 13; ++k) {
    cosine_term = -cosine_term * square / static_cast<double>((2 * k - 1) * (2 * k));
    sine_term = -sine_term * square / static_cast<double>((2 * k) * (2 * k + 1));
    c += cosine_term;
    s += sine_term;
  }
  *cosine = c * c - s * s;
  *sine = 2 * c * s;
}

struct Vec3d {
  double x = 0, y = 0, z = 0;
};
inline Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3d operator-(Vec3d a) { return {-a.x, -a.y, -a.z}; }
inline Vec3d operator*(double s, Vec3d a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3d cross(Vec3d a, Vec3d b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Vec3d to_double(Vec3i v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// 1 / sqrt(x) for normal x > 0: a guess that halves the exponent, 3.5 % off, and five Newton steps, each of which squares
// the error.
inline double reciprocal_root(double x) {
  uint64_t word;
  memcpy(&word, &x, sizeof word);
  word = 0x5FE6EB50C7B537A9u - (word >> 1);
  double y;
  memcpy(&y, &word, sizeof y);
  for (int i = 0; i < 5; ++i) y = y * (1.5 - 0.5 * x * y * y);
  return y;
}

constexpr double kLeastSquare = 1e-280;  // what is below it has no root and no length

inline double root(double x) { return x > kLeastSquare ? x * reciprocal_root(x) : 0.0; }
inline double length(Vec3d v) { return root(dot(v, v)); }
// v / |v|, (0, 0, 0) for what has no length.
inline Vec3d unit(Vec3d v) {
  const double square = dot(v, v);
  return square > kLeastSquare ? reciprocal_root(square) * v : Vec3d{0, 0, 0};
}
// Squared distance of p from the segment from a to b.
inline double square_to_segment(Vec3d p, Vec3d a, Vec3d b) {
  const Vec3d along = b - a, from = p - a;
  const double square = dot(along, along);
  const Vec3d off = from - (square > kLeastSquare ? clamped(dot(from, along) / square, 0, 1) : 0) * along;
  return dot(off, off);
}

}  // namespace sinew
#endif
