// SPDX-License-Identifier: MIT
// Logarithm and hyperbolic tangent from additions, products and quotients alone, which round alike everywhere.
#include "mapping/maths.hpp"

#include <string.h>

namespace sinew::mapping {
namespace {

uint64_t bits_of(double a) {
  uint64_t bits;
  memcpy(&bits, &a, sizeof bits);
  return bits;
}

double from_bits(uint64_t bits) {
  double a;
  memcpy(&a, &bits, sizeof a);
  return a;
}

constexpr double kLn2 = 0.69314718055994530942;

// e^a for 0 <= a <= 40: 2^k times the series of what is left, which is below 0.35.
double exponential(double a) {
  const int64_t k = static_cast<int64_t>(a / kLn2 + 0.5);
  const double r = a - static_cast<double>(k) * kLn2;
  double sum = 1;
  for (int n = 14; n > 0; --n) sum = 1 + sum * r / n;  // the rest is below 0.35^15 / 15! = 1e-19
  return sum * from_bits(static_cast<uint64_t>(1023 + k) << 52);
}

}  // namespace

double logarithm(double a) {
  if (!(a > 1e-300)) a = 1e-300;
  const uint64_t bits = bits_of(a);
  int64_t exponent = static_cast<int64_t>(bits >> 52) - 1023;
  double m = from_bits((bits & 0xFFFFFFFFFFFFFu) | (static_cast<uint64_t>(1023) << 52));  // 1 .. 2
  if (m > 1.41421356237309504880) {
    m *= 0.5;
    ++exponent;
  }
  const double t = (m - 1) / (m + 1), square = t * t;  // |t| < 0.172: 0.172^23 / 23 = 1e-19
  double sum = 0;
  for (int n = 21; n > 0; n -= 2) sum = 1.0 / n + square * sum;
  return static_cast<double>(exponent) * kLn2 + 2 * t * sum;
}

double hyperbolic_tangent(double a) {
  const double b = absolute(a);
  const double t = b > 20 ? 1 : 1 - 2 / (exponential(2 * b) + 1);
  return a < 0 ? -t : t;
}

}  // namespace sinew::mapping
