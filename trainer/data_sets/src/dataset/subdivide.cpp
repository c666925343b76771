// SPDX-License-Identifier: MIT
// Finer variants of a character: every triangle into four.
#include <algorithm>
#include <map>
#include <utility>

#include "sinew_data_sets/dataset.hpp"

namespace sinew {
namespace {

// The mean of two rows, by falling weight, ties by the lower joint.
std::vector<Influence> mean_row(const std::vector<Influence>& a, const std::vector<Influence>& b) {
  std::map<uint32_t, float> sums;
  for (const Influence& i : a) sums[i.joint] += i.weight / 2;
  for (const Influence& i : b) sums[i.joint] += i.weight / 2;
  std::vector<Influence> row;
  for (const auto& [joint, weight] : sums) row.push_back({joint, weight});
  std::stable_sort(row.begin(), row.end(), [](const Influence& x, const Influence& y) { return x.weight > y.weight; });
  return row;
}

}  // namespace

Character subdivide(const Character& character) {
  Character out;
  out.name = character.name;
  out.vertices = character.vertices;
  out.joints = character.joints;
  out.influences = character.influences;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [at, is_new] = middles.emplace(std::minmax(a, b), static_cast<uint32_t>(out.vertices.size()));
    if (is_new) {
      const Vec3 p = out.vertices[a], q = out.vertices[b];
      out.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
      if (!out.influences.empty()) out.influences.push_back(mean_row(out.influences[a], out.influences[b]));
    }
    return at->second;
  };
  for (size_t f = 0; f < character.face_count(); ++f) {
    for (uint32_t i = character.face_offsets[f] + 1; i + 1 < character.face_offsets[f + 1]; ++i) {
      const uint32_t p = character.face_vertices[character.face_offsets[f]], q = character.face_vertices[i],
                     r = character.face_vertices[i + 1];
      const uint32_t pq = middle(p, q), qr = middle(q, r), rp = middle(r, p);
      for (const uint32_t corner : {p, pq, rp, pq, q, qr, rp, qr, r, pq, qr, rp}) {
        out.face_vertices.push_back(corner);
        if (out.face_vertices.size() % 3 == 0)
          out.face_offsets.push_back(static_cast<uint32_t>(out.face_vertices.size()));
      }
    }
  }
  return out;
}

}  // namespace sinew
