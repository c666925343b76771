// SPDX-License-Identifier: MIT
#include "picture/silhouette.hpp"

#include <algorithm>

namespace sinew {

std::vector<Run> Silhouette::at(float y) const {
  std::vector<float> crossings;
  for (size_t f = 0; f < mesh_.face_count(); ++f)
    for (size_t c = mesh_.face_offsets[f]; c < mesh_.face_offsets[f + 1]; ++c) {
      const size_t next = c + 1 < mesh_.face_offsets[f + 1] ? c + 1 : mesh_.face_offsets[f];
      const Vec3 &a = mesh_.vertices[mesh_.face_vertices[c]], &b = mesh_.vertices[mesh_.face_vertices[next]];
      if (a.z != 0 || b.z != 0 || (a.y > y) == (b.y > y)) continue;
      crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
  std::sort(crossings.begin(), crossings.end());
  // Every edge of the outline is of a triangle in front and of one behind; chords across the figure are of two each, and part a run in two that touch.
  std::vector<Run> runs;
  for (size_t k = 0; k + 3 < crossings.size(); k += 4) {
    if (!runs.empty() && crossings[k] <= runs.back().second)
      runs.back().second = crossings[k + 2];
    else
      runs.push_back({crossings[k], crossings[k + 2]});
  }
  return runs;
}

bool Silhouette::has(float x, float y) const {
  for (const Run& run : at(y))
    if (run.first <= x && x <= run.second) return true;
  return false;
}

}  // namespace sinew
