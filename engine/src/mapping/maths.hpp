// SPDX-License-Identifier: MIT
// Points and functions of doubles with the same bits everywhere: sums and products in one order, no libm.
#ifndef SINEW_MAPPING_MATHS_HPP
#define SINEW_MAPPING_MATHS_HPP

#include <stdint.h>

namespace sinew::mapping {

struct Point {
  double x = 0, y = 0, z = 0;
};

inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator-(const Point& a) { return {-a.x, -a.y, -a.z}; }
inline Point operator*(double s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double absolute(double a) { return a < 0 ? -a : a; }
inline double lesser(double a, double b) { return b < a ? b : a; }
inline double greater(double a, double b) { return a < b ? b : a; }
inline double clamped(double a, double low, double high) { return a < low ? low : a > high ? high : a; }
inline int sign(double a) { return a > 0 ? 1 : a < 0 ? -1 : 0; }

// In units of 1e-9: what is compared so is equal where only roundings differ.
inline int64_t rounded(double a) { return static_cast<int64_t>(a * 1e9 + (a < 0 ? -0.5 : 0.5)); }

// Square root of a number that is at least 0, within two units in the last place; 0 below 1e-200.
double root(double a);
// Natural logarithm of a number above 0, within 1e-15.
double logarithm(double a);
double hyperbolic_tangent(double a);

inline double length(const Point& a) { return root(dot(a, a)); }
inline double distance(const Point& a, const Point& b) { return length(a - b); }
// Of length 1; zero stays zero.
inline Point direction(const Point& a) {
  const double l = length(a);
  return l > 1e-9 ? (1 / l) * a : a;
}

}  // namespace sinew::mapping
#endif
