// SPDX-License-Identifier: MIT
// Two legs of blocks below a trunk, grown together at their lower halves, with a skeleton and true weights.
#ifndef SINEW_TESTS_BLOCK_BODY_HPP
#define SINEW_TESTS_BLOCK_BODY_HPP

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

enum BlockJoint : uint32_t { kHips, kLeftUpLeg, kLeftLeg, kRightUpLeg, kRightLeg };

// Cells: legs x 0..4 and 6..10, y 0..10; trunk y 10..14; depth z 0..4. What joins the legs is x 4..6, y 0..6.
//   low, high  of z of what joins the legs: 1, 3 leaves a valley in front and behind; 0, 4 is flush; 0, 0 is nothing
inline Character block_body(int low, int high) {
  const auto solid = [&](int x, int y, int z) {
    if (x < 0 || x >= 10 || y < 0 || y >= 14 || z < 0 || z >= 4) return false;
    return y >= 10 || x < 4 || x >= 6 || (y < 6 && z >= low && z < high);
  };
  Character body;
  body.name = "blocks";
  std::map<std::array<int, 3>, uint32_t> number;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [found, is_new] = number.emplace(at, static_cast<uint32_t>(body.vertices.size()));
    if (is_new)
      body.vertices.push_back({static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])});
    return found->second;
  };
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 14; ++y)
      for (int z = 0; z < 4; ++z)
        for (int side = 0; side < 6 && solid(x, y, z); ++side) {
          const size_t axis = static_cast<size_t>(side) / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
          const int out = side % 2 == 0 ? -1 : 1;
          std::array<int, 3> beside = {x, y, z}, corner = {x, y, z};
          beside[axis] += out;
          if (solid(beside[0], beside[1], beside[2])) continue;
          if (out > 0) ++corner[axis];
          std::array<std::array<int, 3>, 4> quad = {corner, corner, corner, corner};
          ++quad[1][u];
          ++quad[2][u];
          ++quad[2][v];
          ++quad[3][v];
          if (out < 0) std::swap(quad[1], quad[3]);
          for (const auto& at : quad) body.face_vertices.push_back(vertex(at));
          body.face_offsets.push_back(static_cast<uint32_t>(body.face_vertices.size()));
        }
  body.joints = {{"Hips", {5, 12, 2}, -1},
                 {"LeftUpLeg", {2, 10, 2}, kHips},
                 {"LeftLeg", {2, 5, 2}, kLeftUpLeg},
                 {"RightUpLeg", {8, 10, 2}, kHips},
                 {"RightLeg", {8, 5, 2}, kRightUpLeg}};
  for (const Vec3& p : body.vertices) {
    const bool left = p.x <= 5;
    const uint32_t joint = p.y > 10  ? uint32_t{kHips}
                           : p.y > 5 ? uint32_t{left ? kLeftUpLeg : kRightUpLeg}
                                     : uint32_t{left ? kLeftLeg : kRightLeg};
    body.influences.push_back({{joint, 1.0f}});
  }
  return body;
}

// Weights as a binder gives them that sees one surface: a third of what lies between the legs is the other one's.
inline std::vector<std::vector<Influence>> blurred(const Character& body) {
  std::vector<std::vector<Influence>> rows = body.influences;
  for (size_t v = 0; v < rows.size(); ++v) {
    const uint32_t joint = rows[v][0].joint;
    const uint32_t other = joint == kHips ? uint32_t{kHips} : joint < kRightUpLeg ? joint + 2 : joint - 2;
    if (other != joint && body.vertices[v].x >= 3 && body.vertices[v].x <= 7)
      rows[v] = {{joint, 0.67f}, {other, 0.33f}};
  }
  return rows;
}

// The same body, all its faces turned inside out.
inline Character inside_out(Character body) {
  for (size_t f = 0; f < body.face_count(); ++f)
    std::reverse(body.face_vertices.begin() + body.face_offsets[f],
                 body.face_vertices.begin() + body.face_offsets[f + 1]);
  return body;
}

}  // namespace sinew
#endif
