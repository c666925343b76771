// SPDX-License-Identifier: MIT
// Horizontal cross-sections of a mesh as curves: the cuts of a plane with its surface, one curve per connected
// component.
#ifndef SINEW_SPRINGS_SECTIONS_HPP
#define SINEW_SPRINGS_SECTIONS_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// A point of a section: to the left and to the front.
using Point2 = std::array<double, 2>;
inline Point2 operator-(const Point2& a, const Point2& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline double length(const Point2& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1]); }
// The angle of a direction from the front over the left, as a share of a full circle, 0..1.
double angle_of(const Point2& direction);

// A curve of a section: the cuts of triangles that share edges.
struct SectionCurve {
  std::vector<std::array<Point2, 2>> segments;
  std::vector<uint32_t> triangles;  // [segments] which triangle each cuts

  // The share of a full circle around `middle` that the curve covers, 0..1.
  double covered_turn(const Point2& middle) const;
  // Mean distance of its segments' middles from `middle`, by their lengths.
  double mean_distance(const Point2& middle) const;
  double total_length() const;
};

// A mesh in a body's directions, to be cut.
class SectionedMesh {
 public:
  //   left, front, up  unit vectors at right angles
  SectionedMesh(const Character& character, const Point3& left, const Point3& front, const Point3& up);

  const std::vector<std::array<uint32_t, 3>>& triangles() const { return triangles_; }
  double height(size_t vertex) const { return heights_[vertex]; }
  const Point2& across(size_t vertex) const { return across_[vertex]; }
  Point2 across(const Point3& p) const { return {dot(p, left_), dot(p, front_)}; }
  double height(const Point3& p) const { return dot(p, up_); }
  Point3 point_at(const Point2& across, double height) const {
    return across[0] * left_ + across[1] * front_ + height * up_;
  }

  // The curves at levels from `top` down, `count` of them at equal distances to `bottom`; both are among them. [count][curves]
  std::vector<std::vector<SectionCurve>> sections(double top, double bottom, size_t count) const;

 private:
  Point3 left_, front_, up_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<uint32_t> first_;  // [V] the first vertex at its position
  std::vector<double> heights_;  // [V]
  std::vector<Point2> across_;   // [V]
};

}  // namespace sinew
#endif
