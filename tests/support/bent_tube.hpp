// SPDX-License-Identifier: MIT
// A closed tube along x with a chain of joints, its weights, and palettes that turn its joints.
#ifndef SINEW_TESTS_SUPPORT_BENT_TUBE_HPP
#define SINEW_TESTS_SUPPORT_BENT_TUBE_HPP

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace sinew_test {

struct BentTube {
  static constexpr uint32_t kRings = 41, kAround = 16;
  std::vector<float> positions, joint_positions;
  std::vector<uint32_t> corners;
  std::vector<int32_t> parents;
  std::vector<uint16_t> joints, weights;

  // From x = -1 to 1; joints at -1, ... evenly; the blend between two is `blend` wide.
  explicit BentTube(uint32_t joint_count = 2, double blend = 0.3, double radius = 0.2) {
    for (uint32_t r = 0; r < kRings; ++r) {
      const double x = -1 + 2.0 * r / (kRings - 1);
      for (uint32_t k = 0; k < kAround; ++k) {
        const double angle = 2 * 3.14159265358979 * k / kAround;
        add_vertex(x, radius * std::cos(angle), radius * std::sin(angle));
      }
    }
    for (uint32_t r = 0; r + 1 < kRings; ++r) {
      for (uint32_t k = 0; k < kAround; ++k) {
        const uint32_t a = r * kAround + k, b = r * kAround + (k + 1) % kAround;
        corners.insert(corners.end(), {a, b, a + kAround, b, b + kAround, a + kAround});
      }
    }
    const uint32_t begin = add_vertex(-1, 0, 0), end = add_vertex(1, 0, 0), last = (kRings - 1) * kAround;
    for (uint32_t k = 0; k < kAround; ++k) {
      corners.insert(corners.end(), {begin, (k + 1) % kAround, k});
      corners.insert(corners.end(), {end, last + k, last + (k + 1) % kAround});
    }
    for (uint32_t j = 0; j < joint_count; ++j) {
      joint_positions.insert(joint_positions.end(), {static_cast<float>(-1 + 2.0 * j / joint_count), 0, 0});
      parents.push_back(static_cast<int32_t>(j) - 1);
    }
    for (uint32_t v = 0; v < vertex_count(); ++v) weigh(static_cast<double>(positions[3 * v]), joint_count, blend);
  }

  uint32_t vertex_count() const { return static_cast<uint32_t>(positions.size() / 3); }
  sinew_mesh mesh() const {
    return {positions.data(),
            vertex_count(),
            nullptr,
            corners.data(),
            static_cast<uint32_t>(corners.size() / 3),
            static_cast<uint32_t>(corners.size())};
  }
  sinew_skeleton skeleton() const { return skeleton_of(joint_positions, parents); }
  sinew_skin skin() const { return {joints.data(), weights.data(), 2, SINEW_WEIGHT_UNORM16}; }

  // Every joint but the first turned by an angle about an axis through itself, on top of its parent.
  std::vector<float> turned(std::array<double, 3> axis, double degrees) const {
    std::vector<std::array<double, 12>> matrices(parents.size(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    for (size_t j = 1; j < parents.size(); ++j) {
      const std::array<double, 12> own = rotation_about(axis, degrees, static_cast<double>(joint_positions[3 * j]));
      const std::array<double, 12>& above = matrices[j - 1];
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c) {
          double sum = c == 3 ? above[4 * r + 3] : 0;
          for (size_t k = 0; k < 3; ++k) sum += above[4 * r + k] * own[4 * k + c];
          matrices[j][4 * r + c] = sum;
        }
    }
    std::vector<float> palette;
    for (const auto& m : matrices)
      for (const double e : m) palette.push_back(static_cast<float>(e));
    return palette;
  }

  // Six times the volume of the mesh with its vertices elsewhere.
  double volume(const std::vector<float>& at) const {
    double sum = 0;
    for (size_t t = 0; t < corners.size(); t += 3) {
      const float *a = &at[3 * corners[t]], *b = &at[3 * corners[t + 1]], *c = &at[3 * corners[t + 2]];
      sum += double{a[0]} * (double{b[1]} * c[2] - double{b[2]} * c[1]) +
             double{a[1]} * (double{b[2]} * c[0] - double{b[0]} * c[2]) +
             double{a[2]} * (double{b[0]} * c[1] - double{b[1]} * c[0]);
    }
    return sum;
  }

  // About an axis through (x, 0, 0), row-major 3x4.
  static std::array<double, 12> rotation_about(std::array<double, 3> axis, double degrees, double x) {
    const double n = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    for (double& a : axis) a /= n;
    const double angle = degrees * 3.14159265358979 / 180, c = std::cos(angle), s = std::sin(angle);
    const auto [p, q, r] = axis;
    std::array<double, 12> m = {c + p * p * (1 - c),     p * q * (1 - c) - r * s, p * r * (1 - c) + q * s, 0,
                                q * p * (1 - c) + r * s, c + q * q * (1 - c),     q * r * (1 - c) - p * s, 0,
                                r * p * (1 - c) - q * s, r * q * (1 - c) + p * s, c + r * r * (1 - c),     0};
    for (size_t row = 0; row < 3; ++row) m[4 * row + 3] = (row == 0 ? x : 0) - m[4 * row] * x;
    return m;
  }

 private:
  uint32_t add_vertex(double x, double y, double z) {
    positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    return vertex_count() - 1;
  }
  void weigh(double x, uint32_t joint_count, double blend) {
    uint32_t below = 0;
    double share = 0;  // of the next joint
    for (uint32_t j = 1; j < joint_count; ++j) {
      const double at = (x - (-1 + 2.0 * j / joint_count)) / blend + 0.5;
      if (at >= 1) below = j;
      if (at > 0 && at < 1) {
        below = j - 1;
        share = at;
      }
    }
    const uint16_t next = static_cast<uint16_t>(share * 65535 + 0.5), own = static_cast<uint16_t>(65535 - next);
    const uint16_t b = static_cast<uint16_t>(below);
    const uint16_t above = static_cast<uint16_t>(below + 1 < joint_count ? below + 1 : below);
    const bool swap = next > own;  // by falling weight
    joints.insert(joints.end(), {swap ? above : b, swap ? b : above});
    weights.insert(weights.end(), {swap ? next : own, swap ? own : next});
  }
};

}  // namespace sinew_test
#endif
