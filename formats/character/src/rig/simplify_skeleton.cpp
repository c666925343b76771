// SPDX-License-Identifier: MIT
// Areas of the joints and their middles from weights and faces, the engine's answer, and the character put together anew.
#include "sinew_character/simplify_skeleton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sinew/sinew.hpp"
#include "sinew_character/engine_views.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double u[3] = {double{b.x} - a.x, double{b.y} - a.y, double{b.z} - a.z};
  const double v[3] = {double{c.x} - a.x, double{c.y} - a.y, double{c.z} - a.z};
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

// [V] a third of the faces around a vertex; all alike where there is no surface.
std::vector<double> vertex_areas(const Character& c) {
  std::vector<double> areas(c.vertices.size(), 0.0);
  double whole = 0;
  for (size_t f = 0; f + 1 < c.face_offsets.size(); ++f) {
    const uint32_t* const corners = c.face_vertices.data() + c.face_offsets[f];
    for (size_t k = 2; k < c.face_offsets[f + 1] - c.face_offsets[f]; ++k) {
      const uint32_t triangle[3] = {corners[0], corners[k - 1], corners[k]};
      const double third = triangle_area(c.vertices[triangle[0]], c.vertices[triangle[1]], c.vertices[triangle[2]]) / 3;
      for (const uint32_t v : triangle) areas[v] += third;
      whole += third;
    }
  }
  if (!(whole > 0)) areas.assign(areas.size(), 1.0);
  return areas;
}

// Of the surface that moves with each joint.
struct JointSurfaces {
  std::vector<float> shares;     // [J]
  std::vector<float> centroids;  // [J x 3] the joint's position where nothing moves with it
};

// Empty without weights. Vertices are the samples, each as large as the faces around it.
JointSurfaces joint_surfaces(const Character& c) {
  if (c.influences.empty()) return {};
  const std::vector<double> areas = vertex_areas(c);
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

void merge_weights(const Simplified& simplified, std::vector<Influence>* row) {
  std::map<uint32_t, float> sums;
  for (const Influence& influence : *row)
    sums[static_cast<uint32_t>(simplified.number[simplified.into[influence.joint]])] += influence.weight;
  row->clear();
  for (const auto& [joint, weight] : sums) row->push_back({joint, weight});
  std::stable_sort(row->begin(), row->end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
}

std::vector<uint8_t> kept_joints(const SimplifyOptions& options, const Character& c) {
  std::vector<uint8_t> keep(c.joints.size(), 0);
  for (const std::string& name : options.keep) {
    bool found = false;
    for (size_t j = 0; j < c.joints.size(); ++j) {
      if (c.joints[j].name != name) continue;
      found = true;
      keep[j] = 1;
    }
    if (!found) throw Error(c.name + ": no joint is called " + name + ", which is to be kept");
  }
  for (const uint32_t j : options.keep_joints) keep.at(j) = 1;
  return keep;
}

}  // namespace

std::vector<uint32_t> joints_to_merge(const SimplifyOptions& options, const Character& character) {
  const std::vector<Joint>& joints = character.joints;
  if (joints.empty()) throw Error(character.name + ": no joints to simplify");
  const std::vector<uint8_t> keep = kept_joints(options, character);
  const SkeletonView view(joints);
  const JointSurfaces surfaces = joint_surfaces(character);
  SimplifySettings settings;
  settings.level = options.low ? SINEW_SIMPLIFY_LOW : SINEW_SIMPLIFY_HIGH;
  settings.joint_count = options.joints;
  if (!surfaces.centroids.empty()) settings.centroids = surfaces.centroids.data();
  Workspace workspace;
  std::vector<uint32_t> into;
  const sinew_status status = simplify(view.skeleton, surfaces.shares.empty() ? nullptr : surfaces.shares.data(),
                                       keep.data(), settings, &workspace, &into);
  if (status != SINEW_OK)
    throw Error(character.name + ": the skeleton cannot be simplified: " + sinew_status_text(status));
  return into;
}

std::vector<Joint> joints_left(const std::vector<Joint>& joints, const std::vector<uint32_t>& into,
                               std::vector<int>* number) {
  number->clear();
  std::vector<Joint> left;
  for (size_t j = 0; j < joints.size(); ++j) {
    number->push_back(into[j] == j ? static_cast<int>(left.size()) : -1);
    if (into[j] == j) left.push_back(joints[j]);
  }
  for (Joint& joint : left) {
    if (joint.parent >= 0) joint.parent = (*number)[into[static_cast<size_t>(joint.parent)]];
  }
  return left;
}

Simplified simplify_skeleton(const SimplifyOptions& options, Character* character) {
  Simplified simplified;
  simplified.into = joints_to_merge(options, *character);
  std::vector<Joint> left = joints_left(character->joints, simplified.into, &simplified.number);
  for (std::vector<Influence>& row : character->influences) merge_weights(simplified, &row);
  character->joints = std::move(left);
  return simplified;
}

}  // namespace sinew
