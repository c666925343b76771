// SPDX-License-Identifier: MIT
// The common beginning of two meshes.
#include "motion/common_body.hpp"

#include <algorithm>

namespace sinew {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

// Corners of all faces cut into fans, a triangle each.
std::vector<uint32_t> fans(const Character& character) {
  std::vector<uint32_t> corners;
  for (size_t f = 0; f < character.face_count(); ++f)
    for (size_t c = character.face_offsets[f] + 2; c < character.face_offsets[f + 1]; ++c)
      corners.insert(corners.end(), {character.face_vertices[character.face_offsets[f]], character.face_vertices[c - 1],
                                     character.face_vertices[c]});
  return corners;
}

}  // namespace

CommonBody common_body(const Character& first, const Character& second) {
  const std::vector<uint32_t> a = fans(first), b = fans(second);
  std::vector<uint32_t> number_a(first.vertices.size(), kNone), number_b(second.vertices.size(), kNone);
  CommonBody body;
  for (size_t t = 0; t + 2 < std::min(a.size(), b.size()); t += 3) {
    for (size_t c = t; c < t + 3; ++c) {
      if (number_a[a[c]] != number_b[b[c]]) {
        body.triangles.resize(t);
        return body;
      }
      if (number_a[a[c]] == kNone) {
        number_a[a[c]] = number_b[b[c]] = static_cast<uint32_t>(body.first.size());
        body.first.push_back(a[c]);
        body.second.push_back(b[c]);
      }
      body.triangles.push_back(number_a[a[c]]);
    }
  }
  return body;
}

}  // namespace sinew
