// SPDX-License-Identifier: MIT
// Limbs, arms and hands of tubes.
#ifndef SINEW_TESTS_SUPPORT_HAND_SCENE_HPP
#define SINEW_TESTS_SUPPORT_HAND_SCENE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh_scene.hpp"

namespace sinew_test {

// A closed tapered tube from a to b with round ends, x times `side`.
inline void add_limb(MeshScene* scene, const std::array<double, 3>& a, const std::array<double, 3>& b, double from,
                     double to, double side, double flat = 1) {
  constexpr int kAround = 12, kRings = 14;
  using Point = std::array<double, 3>;
  const Point d = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const double length = std::hypot(d[0], d[1], d[2]);
  const Point along = {d[0] / length, d[1] / length, d[2] / length};
  // z without its part along, and what is across both
  Point u = {-along[2] * along[0], -along[2] * along[1], 1 - along[2] * along[2]};
  const double norm = std::hypot(u[0], u[1], u[2]);
  for (double& x : u) x /= norm;
  const Point w = {along[1] * u[2] - along[2] * u[1], along[2] * u[0] - along[0] * u[2],
                   along[0] * u[1] - along[1] * u[0]};
  const uint32_t first = scene->vertex_count();
  for (int r = 0; r <= kRings; ++r) {
    const double t = static_cast<double>(r) / kRings, radius = from + (to - from) * t;
    const double in = std::min(t, 1 - t) * length / radius;  // of the round end
    const double here = in < 1 ? radius * std::sqrt(std::max(1 - (1 - in) * (1 - in), 0.01)) : radius;
    for (int s = 0; s < kAround; ++s) {
      const double angle = 2 * M_PI * s / kAround, c = here * std::cos(angle), h = here * flat * std::sin(angle);
      Point p;
      for (size_t i = 0; i < 3; ++i) p[i] = a[i] + t * d[i] + c * u[i] + h * w[i];
      scene->add_vertex(static_cast<float>(side * p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
    }
  }
  const auto at = [&](int r, int s) { return first + static_cast<uint32_t>(r * kAround + s % kAround); };
  const auto add = [&](std::vector<uint32_t> face) {
    if (side < 0) face = std::vector<uint32_t>(face.rbegin(), face.rend());
    scene->add_face(face);
  };
  for (int r = 0; r < kRings; ++r)
    for (int s = 0; s < kAround; ++s) add({at(r, s), at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
  std::vector<uint32_t> front, back;
  for (int s = 0; s < kAround; ++s) {
    front.push_back(at(0, kAround - 1 - s));
    back.push_back(at(kRings, s));
  }
  add(front);
  add(back);
}

// A hand that faces down with its wrist at (0.62, 1.4, 0), its longest finger to x = 0.79; times `side` along x.
inline void add_hand(MeshScene* scene, double side, bool fingers = true) {
  add_limb(scene, {0.585, 1.4, 0}, {0.71, 1.4, 0}, 0.035, 0.042, side, 0.35);
  if (!fingers) return;
  add_limb(scene, {0.62, 1.395, 0.02}, {0.69, 1.385, 0.085}, 0.013, 0.01, side);
  constexpr double kReach[4] = {0.775, 0.79, 0.778, 0.755};
  for (int f = 0; f < 4; ++f) {
    const double z = 0.033 - 0.022 * f;
    add_limb(scene, {0.68, 1.4, z}, {kReach[f], 1.397, 1.25 * z}, 0.0095, 0.0075, side);
  }
}

// A trunk and two arms along x with such hands: wrists at x = 0.6.
inline MeshScene two_arms(bool fingers) {
  MeshScene scene;
  add_limb(&scene, {0, 0.9, 0}, {0, 1.5, 0}, 0.14, 0.14, 1);
  for (const double side : {1.0, -1.0}) {
    add_limb(&scene, {0.1, 1.4, 0}, {0.62, 1.4, 0}, 0.05, 0.028, side);
    add_hand(&scene, side, fingers);
  }
  return scene;
}

}  // namespace sinew_test
#endif
