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

void keep_skin(const Character& first, const std::vector<bool>& in_hand, CommonBody* body) {
  std::vector<uint32_t> piece(body->first.size());
  for (uint32_t v = 0; v < piece.size(); ++v) piece[v] = v;
  const auto find = [&piece](uint32_t v) {
    while (piece[v] != v) v = piece[v] = piece[piece[v]];
    return v;
  };
  for (size_t i = 0; i < body->triangles.size(); ++i)
    if (i % 3 != 0) piece[find(body->triangles[i])] = find(body->triangles[i - 1]);
  std::vector<uint8_t> reaches(piece.size(), 0);  // 1: has a hand, 2: has something else
  for (uint32_t v = 0; v < piece.size(); ++v) {
    const std::vector<Influence>& row = first.influences[body->first[v]];
    const auto most = std::max_element(row.begin(), row.end(),
                                       [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
    if (most == row.end()) continue;
    uint8_t& own = reaches[find(v)];
    own = static_cast<uint8_t>(own | (in_hand[most->joint] ? 1 : 2));
  }
  std::vector<size_t> size(piece.size(), 0);
  for (size_t t = 0; t < body->triangles.size(); t += 3) ++size[find(body->triangles[t])];
  std::vector<uint32_t> kept;
  for (size_t t = 0; t < body->triangles.size(); t += 3) {
    const uint32_t own = find(body->triangles[t]);
    if (reaches[own] != 3 || 12 * size[own] < body->triangles.size()) continue;
    for (size_t c = t; c < t + 3; ++c) kept.push_back(body->triangles[c]);
  }
  if (!kept.empty()) body->triangles = std::move(kept);
}

}  // namespace sinew
