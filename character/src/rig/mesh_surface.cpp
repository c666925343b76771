// SPDX-License-Identifier: MIT
// Neighbors by positions and edges.
#include "sinew_character/rig/mesh_surface.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

#include "sinew_formats/vertex_areas.hpp"

namespace sinew {

std::vector<uint32_t> first_at_position(const Character& character) {
  std::map<std::array<float, 3>, uint32_t> first;
  std::vector<uint32_t> positions;
  positions.reserve(character.vertices.size());
  for (uint32_t v = 0; v < character.vertices.size(); ++v) {
    const Vec3& p = character.vertices[v];
    positions.push_back(first.emplace(std::array<float, 3>{p.x, p.y, p.z}, v).first->second);
  }
  return positions;
}

std::vector<std::vector<uint32_t>> welded_rings(const Character& c, const std::vector<uint32_t>& first) {
  std::vector<std::vector<uint32_t>> rings(c.vertices.size());
  for (size_t f = 0; f < c.face_count(); ++f) {
    const uint32_t begin = c.face_offsets[f], end = c.face_offsets[f + 1];
    for (uint32_t k = begin; k < end; ++k) {
      const uint32_t a = first[c.face_vertices[k]], b = first[c.face_vertices[k + 1 < end ? k + 1 : begin]];
      if (a == b) continue;
      rings[a].push_back(b);
      rings[b].push_back(a);
    }
  }
  for (auto& ring : rings) {
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  }
  return rings;
}

std::vector<std::vector<uint32_t>> neighbors_of(const Character& character) {
  const std::vector<uint32_t> positions = first_at_position(character);
  std::vector<std::vector<uint32_t>> neighbors(positions.size());
  const auto join = [&](uint32_t a, uint32_t b) {
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  };
  for (uint32_t v = 0; v < positions.size(); ++v)
    if (positions[v] != v) join(v, positions[v]);
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t c = first; c < end; ++c)
      join(character.face_vertices[c], character.face_vertices[c + 1 < end ? c + 1 : first]);
  }
  return neighbors;
}

// Areas of faces to vertices, of vertices to joints.

namespace {

// [V] as vertex_areas(); all alike where there is no surface.
std::vector<double> shares_of_vertices(const Character& c) {
  std::vector<double> areas = vertex_areas(c);
  if (!std::any_of(areas.begin(), areas.end(), [](double area) { return area > 0; })) areas.assign(areas.size(), 1.0);
  return areas;
}

}  // namespace

std::vector<std::array<uint32_t, 3>> fan_triangles(const Character& character) {
  std::vector<std::array<uint32_t, 3>> out;
  for (size_t f = 0; f < character.face_count(); ++f)
    for (uint32_t c = character.face_offsets[f] + 2; c < character.face_offsets[f + 1]; ++c)
      out.push_back({character.face_vertices[character.face_offsets[f]], character.face_vertices[c - 1],
                     character.face_vertices[c]});
  return out;
}

JointSurfaces joint_surfaces(const Character& c) {
  if (c.influences.empty()) return {};
  const std::vector<double> areas = shares_of_vertices(c);
  std::vector<double> sums(c.joints.size(), 0.0);
  std::vector<std::array<double, 3>> middles(c.joints.size());
  double whole = 0;
  for (size_t v = 0; v < c.influences.size(); ++v) {
    const Vec3& p = c.vertices[v];
    for (const Influence& influence : c.influences[v]) {
      const double share = areas[v] * influence.weight;
      sums.at(influence.joint) += share;
      std::array<double, 3>& middle = middles[influence.joint];
      middle = {middle[0] + share * p.x, middle[1] + share * p.y, middle[2] + share * p.z};
      whole += share;
    }
  }
  if (!(whole > 0)) return {};
  JointSurfaces surfaces;
  for (size_t j = 0; j < sums.size(); ++j) {
    surfaces.shares.push_back(static_cast<float>(sums[j] / whole));
    const Vec3& at = c.joints[j].position;
    const float own[3] = {at.x, at.y, at.z};
    for (size_t axis = 0; axis < 3; ++axis)
      surfaces.centroids.push_back(sums[j] > 0 ? static_cast<float>(middles[j][axis] / sums[j]) : own[axis]);
  }
  return surfaces;
}

MeshParts connected_parts(const Character& character) {
  const std::vector<uint32_t> first = first_at_position(character);
  VertexGroups groups(character.vertices.size());
  for (size_t f = 0; f < character.face_count(); ++f)
    for (uint32_t c = character.face_offsets[f] + 1; c < character.face_offsets[f + 1]; ++c)
      groups.join(first[character.face_vertices[c - 1]], first[character.face_vertices[c]]);
  MeshParts parts;
  parts.part.resize(character.vertices.size());
  for (uint32_t v = 0; v < parts.part.size(); ++v) {  // a group's least vertex comes first
    const uint32_t group = groups.of(first[v]);
    parts.part[v] = group == v ? static_cast<uint32_t>(parts.count++) : parts.part[group];
  }
  return parts;
}

MeshPart part_without(const Character& whole, const std::vector<uint8_t>& left_out) {
  MeshPart part;
  part.character.name = whole.name;
  part.character.joints = whole.joints;
  std::vector<uint32_t> number(whole.vertices.size(), UINT32_MAX);
  for (size_t v = 0; v < whole.vertices.size(); ++v) {
    if (left_out[v] != 0) continue;
    number[v] = static_cast<uint32_t>(part.vertices.size());
    part.vertices.push_back(v);
    part.character.vertices.push_back(whole.vertices[v]);
    if (!whole.influences.empty()) part.character.influences.push_back(whole.influences[v]);
  }
  for (size_t f = 0; f < whole.face_count(); ++f) {
    const size_t first = whole.face_offsets[f], last = whole.face_offsets[f + 1];
    const auto is_out = [&](uint32_t v) { return number[v] == UINT32_MAX; };
    if (first == last || std::any_of(whole.face_vertices.begin() + static_cast<std::ptrdiff_t>(first),
                                     whole.face_vertices.begin() + static_cast<std::ptrdiff_t>(last), is_out))
      continue;
    for (size_t c = first; c < last; ++c) part.character.face_vertices.push_back(number[whole.face_vertices[c]]);
    part.character.face_offsets.push_back(static_cast<uint32_t>(part.character.face_vertices.size()));
  }
  return part;
}

}  // namespace sinew
