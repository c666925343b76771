// SPDX-License-Identifier: MIT
// Delaunay's triangulation of points in the plane, one after the other (Bowyer, Watson 1981), exact in 64-bit integers.
#ifndef SINEW_CHARACTER_PICTURE_MESH_DELAUNAY_HPP
#define SINEW_CHARACTER_PICTURE_MESH_DELAUNAY_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sinew::picture {

class Delaunay {
 public:
  // Coordinates of all points are 0..kMost: products of four differences, twelve of them, stay below 2^63.
  static constexpr int64_t kMost = 20000;

  Delaunay();
  // Its number, that of an earlier point at the same position.
  uint32_t insert(int64_t x, int64_t y);
  // Corners left about, numbers of insert(); those at the four corners of the plane are left out.
  std::vector<std::array<uint32_t, 3>> triangles() const;

 private:
  static constexpr uint32_t kFrame = 4;  // points of a square around all
  static constexpr int32_t kNone = -1;
  struct Triangle {
    std::array<uint32_t, 3> corners;
    std::array<int32_t, 3> beyond;  // across from each corner
    bool alive = true;
  };
  int64_t area(uint32_t a, uint32_t b, int64_t x, int64_t y) const;
  bool in_circle(const Triangle& t, int64_t x, int64_t y) const;
  size_t triangle_at(int64_t x, int64_t y) const;

  std::vector<std::array<int64_t, 2>> points_;
  std::vector<Triangle> all_;
  std::vector<int32_t> free_;
  size_t last_ = 0;
};

}  // namespace sinew::picture
#endif
