// SPDX-License-Identifier: MIT
// Functions of doubles and points with the same bits everywhere: sums and products in one order, no libm.
#ifndef SINEW_MAPPING_MATHS_HPP
#define SINEW_MAPPING_MATHS_HPP

#include <stdint.h>

#include "core/vec3d.hpp"

namespace sinew::mapping {

using Point = Vec3d;

inline int sign(double a) { return a > 0 ? 1 : a < 0 ? -1 : 0; }

// In units of 1e-9: what is compared so is equal where only roundings differ.
inline int64_t rounded(double a) { return static_cast<int64_t>(a * 1e9 + (a < 0 ? -0.5 : 0.5)); }

// Natural logarithm of a number above 0, within 1e-15.
double logarithm(double a);
double hyperbolic_tangent(double a);

inline double distance(const Point& a, const Point& b) { return length(a - b); }
// Of length 1; zero stays zero.
inline Point direction(const Point& a) {
  const double l = length(a);
  return l > 1e-9 ? (1 / l) * a : a;
}

}  // namespace sinew::mapping
#endif
