// SPDX-License-Identifier: MIT
// Seams by true weights, and what a prediction has across them.
#include <algorithm>

#include "bind/seam_steps.hpp"
#include "sinew_character/bind/seams.hpp"

namespace sinew {
namespace {

constexpr double kAround = 0.05;  // of the size

double weight_of(const std::vector<Influence>& row, uint32_t joint) {
  double weight = 0, sum = 0;
  for (const Influence& one : row) {
    sum += static_cast<double>(one.weight);
    if (one.joint == joint) weight += static_cast<double>(one.weight);
  }
  return sum > 0 ? weight / sum : 0;
}

// A third of the triangles around each welded vertex.
std::vector<double> areas(const Character& character, const SeamSurface& surface) {
  std::vector<double> areas(surface.positions.size(), 0);
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t c = first + 2; c < end; ++c) {
      const uint32_t corners[3] = {surface.welded[character.face_vertices[first]],
                                   surface.welded[character.face_vertices[c - 1]],
                                   surface.welded[character.face_vertices[c]]};
      const Point3 &a = surface.positions[corners[0]], &b = surface.positions[corners[1]],
                   &d = surface.positions[corners[2]];
      for (const uint32_t corner : corners) areas[corner] += length(cross(b - a, d - a)) / 6;
    }
  }
  return areas;
}

}  // namespace

SeamLeak measure_seam_leak(const Character& character, const WeightRows& rows) {
  const SeamSurface surface(character);
  const SkeletonPaths paths(character.joints, surface.size);
  const WeightRows& truth = character.influences;
  std::vector<uint32_t> homes(truth.size(), kNoHome), seam;
  for (uint32_t v = 0; v < truth.size(); ++v) homes[v] = home_joint(truth[v]);
  const auto bone_point = [&](uint32_t joint, uint32_t v) { return paths.nearest(joint, surface.positions[v]); };
  for (uint32_t e = 0; e < surface.edges.size(); ++e) {
    const uint32_t from = surface.edges[e].from, to = surface.edges[e].to;
    if (homes[from] != homes[to] && homes[from] != kNoHome && homes[to] != kNoHome &&
        paths.are_apart(bone_point(homes[from], from), bone_point(homes[to], to)))
      seam.push_back(e);
  }
  if (seam.size() < kFewestEdges) return {};
  const std::vector<double> area = areas(character, surface);
  double all = 0, near = 0, wrong = 0;
  for (uint32_t v = 0; v < truth.size(); ++v) {
    all += area[v];
    if (area[v] <= 0 || homes[v] == kNoHome) continue;
    std::vector<uint32_t> others;
    for (const uint32_t e : seam) {
      const uint32_t from = surface.edges[e].from, to = surface.edges[e].to;
      const Point3 middle = 0.5 * (surface.positions[from] + surface.positions[to]);
      if (length(middle - surface.positions[v]) > kAround * surface.size) continue;
      others.push_back(homes[from]);
      others.push_back(homes[to]);
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    const BonePoint home = bone_point(homes[v], v);
    bool any = false;
    double across = 0;
    for (const uint32_t joint : others) {
      if (!paths.are_apart(home, bone_point(joint, v))) continue;
      any = true;
      across += std::max(0.0, weight_of(rows[v], joint) - weight_of(truth[v], joint));
    }
    if (!any) continue;
    near += area[v];
    wrong += area[v] * across;
  }
  return near > 0 ? SeamLeak{near / all, wrong / near} : SeamLeak{};
}

}  // namespace sinew
