// SPDX-License-Identifier: MIT
// Arithmetic of the character generator: only + - * / and sqrt on doubles, in a fixed order, so that a seed gives the
// same character on every machine (libm's sin and cos differ in the last bit from one C library to the next).
#ifndef SINEW_DATA_SETS_SYNTH_MATHS_HPP
#define SINEW_DATA_SETS_SYNTH_MATHS_HPP

#include <cmath>
#include <cstdint>

namespace sinew::synth {

struct Point {
  double x = 0, y = 0, z = 0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator*(Point a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point cross(Point a, Point b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline Point unit(Point a) {
  const double l = length(a);
  return l > 0 ? a * (1 / l) : Point{0, 1, 0};
}
inline Point mix(Point a, Point b, double t) { return a + (b - a) * t; }
inline double mix(double a, double b, double t) { return a + (b - a) * t; }
inline double clamp01(double t) { return t < 0 ? 0 : t > 1 ? 1 : t; }
// 0 at `from`, 1 at `to` (which may be the smaller one), with flat ends.
inline double smooth_step(double from, double to, double v) {
  const double t = clamp01((v - from) / (to - from));
  return t * t * (3 - 2 * t);
}

constexpr double kPi = 3.14159265358979323846;

// Taylor series after reduction to [-pi, pi]; error under 1e-9, which is far below the grid that positions are rounded
// to.
inline double sine(double angle) {
  while (angle > kPi) angle -= 2 * kPi;
  while (angle < -kPi) angle += 2 * kPi;
  const double s = angle * angle;
  double term = angle, sum = angle;
  for (int k = 1; k < 14; ++k) {
    term = -term * s / ((2.0 * k) * (2.0 * k + 1.0));
    sum += term;
  }
  return sum;
}
inline double cosine(double angle) { return sine(angle + kPi / 2); }
// Taylor series; error under 1e-9 for |v| <= 1, which is what proportions need.
inline double exponential(double v) {
  double term = 1, sum = 1;
  for (int k = 1; k < 14; ++k) {
    term = term * v / k;
    sum += term;
  }
  return sum;
}

// splitmix64 (Steele, Lea, Flood 2014): one word of state, good enough for proportions.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t next() {
    uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  double range(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * (1.0 / 9007199254740992.0));
  }
  int integer(int low, int high) { return low + static_cast<int>(next() % static_cast<uint64_t>(high - low + 1)); }
  bool chance(double probability) { return range(0, 1) < probability; }
  // Mean 0, deviation 1: the sum of twelve uniform draws, never beyond 6.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += range(0, 1);
    return sum;
  }

 private:
  uint64_t state_;
};

}  // namespace sinew::synth
#endif
