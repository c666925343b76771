// SPDX-License-Identifier: MIT
// The surface that seams are found on, its edges and normals that look outwards; how far joints are apart along the skeleton.
#include "bind/seam_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/joint_tree.hpp"

namespace sinew {
namespace {

constexpr int kSmoothings = 2;  // of normals: shells of voxels have steps

}  // namespace

std::vector<char> faces_inside_out(const Character& character, const std::vector<uint32_t>& welded) {
  constexpr double kSteps = 65536;  // of the box: in whole steps no rounding depends on a face's direction
  const Box box = box_of(character.vertices);
  const double scale = kSteps / static_cast<double>(box.longest_side());
  const Point3 middle = 0.5 * (point(box.low) + point(box.high));
  std::vector<Point3> grid;
  for (const Vec3& p : character.vertices) {
    grid.push_back(scale * (point(p) - middle));
    for (double& coordinate : grid.back()) coordinate = std::round(coordinate);
  }
  VertexGroups parts(welded.size());
  std::vector<std::array<double, 4>> faces;  // volume; the area that looks along each axis, where there is none
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    Point3 area = {}, corners = {};
    for (uint32_t c = first; c < end; ++c) {
      const Point3& corner = grid[character.face_vertices[c]];
      area = area + cross(corner, grid[character.face_vertices[c + 1 < end ? c + 1 : first]]);
      corners = corners + corner;
      parts.join(welded[character.face_vertices[first]], welded[character.face_vertices[c]]);
    }
    faces.push_back({first < end ? dot(area, corners) / (end - first) : 0, area[0], area[1], area[2]});
  }
  std::vector<std::array<double, 4>> sums(welded.size() + 1,
                                          std::array<double, 4>{});  // the last: of faces without corners
  const auto sum_of = [&](size_t f) -> std::array<double, 4>& {
    const uint32_t first = character.face_offsets[f];
    return sums[first < character.face_offsets[f + 1] ? parts.of(welded[character.face_vertices[first]])
                                                      : welded.size()];
  };
  for (size_t f = 0; f < faces.size(); ++f)
    for (size_t i = 0; i < faces[f].size(); ++i) sum_of(f)[i] += faces[f][i];
  std::vector<char> inside_out;
  for (size_t f = 0; f < faces.size(); ++f) inside_out.push_back(sum_of(f) < std::array<double, 4>{} ? 1 : 0);
  return inside_out;
}

SeamSurface::SeamSurface(const Character& character) : welded(first_at_position(character)) {
  for (const Vec3& p : character.vertices) positions.push_back(point(p));
  size = static_cast<double>(box_of(character.vertices).longest_side());
  find_edges(character);
  find_normals(character);
}

void SeamSurface::find_edges(const Character& character) {
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t c = first; c < end; ++c) {
      const uint32_t a = welded[character.face_vertices[c]],
                     b = welded[character.face_vertices[c + 1 < end ? c + 1 : first]];
      if (a != b) pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  offsets.assign(positions.size() + 1, 0);
  for (const auto& [a, b] : pairs) {
    edges.push_back({a, b, length(positions[b] - positions[a]), 0});
    ++offsets[a + 1];
    ++offsets[b + 1];
  }
  for (size_t v = 0; v < positions.size(); ++v) offsets[v + 1] += offsets[v];
  std::vector<uint32_t> next(offsets.begin(), offsets.end() - 1);
  around.resize(2 * edges.size());
  for (uint32_t e = 0; e < edges.size(); ++e) {
    around[next[edges[e].from]++] = e;
    around[next[edges[e].to]++] = e;
  }
}

void SeamSurface::find_normals(const Character& character) {
  const std::vector<char> inside_out = faces_inside_out(character, welded);
  std::vector<Point3> sums(positions.size(), Point3{});
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    const auto vertex_at = [&](uint32_t c) {
      return welded[character.face_vertices[inside_out[f] != 0 ? first + end - 1 - c : c]];
    };
    for (uint32_t c = first + 2; c < end; ++c) {
      const uint32_t corners[3] = {vertex_at(first), vertex_at(c - 1), vertex_at(c)};
      const Point3 normal =
          cross(positions[corners[1]] - positions[corners[0]], positions[corners[2]] - positions[corners[0]]);
      for (const uint32_t corner : corners) sums[corner] = sums[corner] + normal;
    }
  }
  for (Point3& sum : sums) sum = unit(sum);
  normals = sums;
  for (int round = 0; round < kSmoothings; ++round) {
    std::vector<Point3> smoothed = sums;
    for (const SurfaceEdge& edge : edges) {
      smoothed[edge.from] = smoothed[edge.from] + sums[edge.to];
      smoothed[edge.to] = smoothed[edge.to] + sums[edge.from];
    }
    for (size_t v = 0; v < sums.size(); ++v) sums[v] = unit(smoothed[v]);
  }
  for (SurfaceEdge& edge : edges) {
    const Point3 along = unit(positions[edge.to] - positions[edge.from]);
    edge.turn = dot(sums[edge.to] - sums[edge.from], along);
  }
}

std::vector<double> SeamSurface::distances(const std::vector<uint32_t>& starts, double most) const {
  std::vector<double> distances(positions.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const uint32_t v : starts) {
    distances[v] = 0;
    queue.emplace(0, v);
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for (uint32_t i = offsets[v]; i < offsets[v + 1]; ++i) {
      const uint32_t other = other_end(around[i], v);
      const double there = distance + edges[around[i]].length;
      if (there > most || there >= distances[other]) continue;
      distances[other] = there;
      queue.emplace(there, other);
    }
  }
  return distances;
}

namespace {

constexpr double kApart = 0.15;  // of the mesh's longest side
constexpr double kDetour = 2.5;  // times the straight distance

}  // namespace

SkeletonPaths::SkeletonPaths(const std::vector<Joint>& joints, double size)
    : size_(size), depths_(joints.size(), 0), bones_(joints.size()) {
  for (const Joint& joint : joints) {
    positions_.push_back(point(joint.position));
    parents_.push_back(joint.parent);
  }
  for (size_t j = 0; j < joints.size(); ++j) {
    for (int up = parents_[j]; up >= 0 && joint_index(depths_[j]) < joints.size(); up = parents_[joint_index(up)])
      ++depths_[j];
    if (parents_[j] >= 0)
      bones_[joint_index(parents_[j])].push_back(positions_[j] - positions_[joint_index(parents_[j])]);
  }
  for (size_t j = 0; j < joints.size(); ++j)
    if (bones_[j].empty() && parents_[j] >= 0)
      bones_[j].push_back(0.5 * (positions_[j] - positions_[joint_index(parents_[j])]));
}

BonePoint SkeletonPaths::nearest(uint32_t joint, const Point3& from) const {
  const Point3 way = from - positions_[joint];
  BonePoint best = {joint, 0, 0, sinew::length(way), positions_[joint]};
  for (uint32_t b = 0; b < bones_[joint].size(); ++b) {
    const Point3& bone = bones_[joint][b];
    const double square = dot(bone, bone);
    if (square <= 0) continue;
    const double along = std::clamp(dot(way, bone) / square, 0.0, 1.0);
    const Point3 position = positions_[joint] + along * bone;
    const double distance = sinew::length(from - position);
    if (distance < best.distance) best = {joint, b, along, distance, position};
  }
  return best;
}

double SkeletonPaths::length(const BonePoint& a, const BonePoint& b) const {
  struct Climb {
    int joint;
    Point3 top;
    double length;
  };
  Climb x = {static_cast<int>(a.joint), a.position, 0}, y = {static_cast<int>(b.joint), b.position, 0};
  const auto climb = [&](Climb* one) {
    const Point3& joint = positions_[joint_index(one->joint)];
    one->length += sinew::length(one->top - joint);
    one->top = joint;
    one->joint = parents_[joint_index(one->joint)];
  };
  while (x.joint != y.joint) {
    Climb* const deeper = depths_[joint_index(x.joint)] >= depths_[joint_index(y.joint)] ? &x : &y;
    climb(deeper);
    if (deeper->joint < 0) return -1;
  }
  return x.length + y.length + sinew::length(x.top - y.top);
}

bool SkeletonPaths::are_apart(const BonePoint& a, const BonePoint& b) const {
  if (a.joint == b.joint) return false;
  const double path = length(a, b);
  return path > kApart * size_ && path > kDetour * sinew::length(a.position - b.position);
}

}  // namespace sinew
