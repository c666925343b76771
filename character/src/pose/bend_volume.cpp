// SPDX-License-Identifier: MIT
// Bends as closed surfaces: patches of triangles with fans over their holes.
#include "sinew_character/pose/bend_volume.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "sinew_character/pose/pose.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr float kLeast = 0.02f, kMost = 0.98f;  // weight of a vertex that moves in part
constexpr double kLeastPart = 0.2;              // of the largest part's volume
// Volume over area^1.5: a ball has 0.09, a limb's piece 0.07, cloth next to nothing.
constexpr double kLeastRoundness = 0.004;

Point3 point(const std::vector<float>& positions, uint32_t v) {
  return {static_cast<double>(positions[3 * v]), static_cast<double>(positions[3 * v + 1]),
          static_cast<double>(positions[3 * v + 2])};
}

// Six times the signed volume between triangles and the point `from`.
double six_volumes(const std::vector<std::array<uint32_t, 3>>& triangles, const std::vector<float>& positions,
                   const Point3& from) {
  double sum = 0;
  for (const auto& t : triangles) {
    const Point3 a = point(positions, t[0]) - from, b = point(positions, t[1]) - from;
    sum += dot(a, cross(b, point(positions, t[2]) - from));
  }
  return sum;
}

}  // namespace

BendVolumes::BendVolumes(const Character& character)
    : position_(first_at_position(character)), influences_(character.influences) {
  for (const Vec3& p : character.vertices) rest_.insert(rest_.end(), {p.x, p.y, p.z});
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t c = first + 2; c < end; ++c) {
      const Triangle t = {position_[character.face_vertices[first]], position_[character.face_vertices[c - 1]],
                          position_[character.face_vertices[c]]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles_.push_back(t);
    }
  }
  (void)joint_tree(character);  // no cycle from here on
  for (const Joint& joint : character.joints) parents_.push_back(joint.parent);
}

std::vector<bool> BendVolumes::moved_by(size_t joint) const {
  std::vector<bool> moved;
  for (int at = 0; at < static_cast<int>(parents_.size()); ++at) {
    int above = at;
    while (above >= 0 && above != static_cast<int>(joint)) above = parents_[static_cast<size_t>(above)];
    moved.push_back(above >= 0);
  }
  return moved;
}

std::vector<BendVolumes::Triangle> BendVolumes::bend_triangles(size_t joint) const {
  const std::vector<bool> moved = moved_by(joint);
  std::vector<uint8_t> in_part(position_.size(), 0), around(position_.size(), 0);
  for (size_t v = 0; v < influences_.size(); ++v) {
    float share = 0;
    for (const Influence& influence : influences_[v])
      if (moved[influence.joint]) share += influence.weight;
    if (share > kLeast && share < kMost) in_part[position_[v]] = 1;
  }
  const auto has = [](const std::vector<uint8_t>& marked, const Triangle& t) {
    return marked[t[0]] != 0 || marked[t[1]] != 0 || marked[t[2]] != 0;
  };
  for (const Triangle& t : triangles_)
    if (has(in_part, t))
      for (const uint32_t v : t) around[v] = 1;
  std::vector<Triangle> found;
  std::copy_if(triangles_.begin(), triangles_.end(), std::back_inserter(found),
               [&](const Triangle& t) { return has(around, t); });
  return found;
}

double BendVolumes::volume(const Part& part, const std::vector<float>& positions) {
  const Point3 from = point(positions, part.triangles[0][0]);  // near, so that differences of large numbers stay exact
  double sum = six_volumes(part.triangles, positions, from);
  for (const auto& hole : part.holes) {
    Point3 middle = {0, 0, 0};
    for (const Edge& edge : hole)
      for (const uint32_t v : edge) {
        const Point3 p = point(positions, v) - from;
        for (size_t i = 0; i < 3; ++i) middle[i] += p[i] / (2.0 * static_cast<double>(hole.size()));
      }
    for (const Edge& edge : hole)  // in the opposite direction of the triangle
      sum += dot(middle, cross(point(positions, edge[1]) - from, point(positions, edge[0]) - from));
  }
  return sum / 6;
}

void BendVolumes::find_holes(Part* part) const {
  std::map<Edge, std::pair<size_t, Edge>>
      edges;  // by its vertices in order: how many triangles have it, and as one has it
  for (const Triangle& t : part->triangles)
    for (size_t i = 0; i < 3; ++i) {
      const Edge edge = {t[i], t[(i + 1) % 3]};
      auto& [count, as_given] = edges[{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}];
      ++count;
      as_given = edge;
    }
  VertexGroups groups(position_.size());
  for (const auto& [key, edge] : edges)
    if (edge.first == 1) groups.join(key[0], key[1]);
  std::map<uint32_t, std::vector<Edge>> holes;
  for (const auto& [key, edge] : edges)
    if (edge.first == 1) holes[groups.of(key[0])].push_back(edge.second);
  for (auto& [group, hole] : holes) part->holes.push_back(std::move(hole));
}

double BendVolumes::area(const Part& part) const {
  double sum = 0;
  for (const Triangle& t : part.triangles) {
    const Point3 a = point(rest_, t[0]);
    const Point3 n = cross(point(rest_, t[1]) - a, point(rest_, t[2]) - a);
    sum += std::sqrt(dot(n, n)) / 2;
  }
  return sum;
}

BendVolumes::Bend BendVolumes::make_bend(size_t joint) const {
  const std::vector<Triangle> found = bend_triangles(joint);
  VertexGroups groups(position_.size());
  for (const Triangle& t : found) {
    groups.join(t[0], t[1]);
    groups.join(t[1], t[2]);
  }
  std::map<uint32_t, Part> parts;
  for (const Triangle& t : found) parts[groups.of(t[0])].triangles.push_back(t);
  double largest = 0;
  for (auto& [group, part] : parts) {
    find_holes(&part);
    part.rest = volume(part, rest_);
    if (std::abs(part.rest) < kLeastRoundness * std::pow(area(part), 1.5)) part.rest = 0;
    largest = std::max(largest, std::abs(part.rest));
  }
  Bend bend;
  for (auto& [group, part] : parts) {
    if (part.rest == 0 || std::abs(part.rest) < kLeastPart * largest) continue;
    bend.rest += std::abs(part.rest);
    bend.parts.push_back(std::move(part));
  }
  return bend;
}

std::optional<double> BendVolumes::kept(size_t joint, const std::vector<float>& positions) {
  auto at = bends_.find(joint);
  if (at == bends_.end()) at = bends_.emplace(joint, make_bend(joint)).first;
  const Bend& bend = at->second;
  if (bend.parts.empty()) return std::nullopt;
  double sum = 0;
  for (const Part& part : bend.parts) sum += (part.rest < 0 ? -1 : 1) * volume(part, positions);
  return sum / bend.rest;
}

}  // namespace sinew
