// SPDX-License-Identifier: MIT
// The yardstick for one character: predicted against reference weights, and how far the skins come apart in random
// poses.
#include "sinew_trainer/evaluate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "sinew_character/check/label_check.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/vertex_areas.hpp"
#include "sinew_trainer/fold_targets.hpp"

namespace sinew {
namespace {

constexpr double kLogFloor = 1e-4;  // both sides of the KL divergence

Point3 scaled(const Vec3& p, double scale) {
  return {static_cast<double>(p.x) * scale, static_cast<double>(p.y) * scale, static_cast<double>(p.z) * scale};
}

// Differences in double, as the yardstick's script has them.
double longest_side(const std::vector<Vec3>& vertices) {
  const auto [low, high] = box_of(vertices);
  return std::max({static_cast<double>(high.x) - static_cast<double>(low.x),
                   static_cast<double>(high.y) - static_cast<double>(low.y),
                   static_cast<double>(high.z) - static_cast<double>(low.z)});
}

// Linear blend skinning; what a row lacks to sum 1 stays at rest.
Point3 skin_point(const std::vector<std::pair<size_t, double>>& row, const std::vector<Affine>& palette,
                  const Point3& p) {
  Point3 out{};
  double lack = 1;
  for (const auto& [joint, weight] : row) {
    const Affine& m = palette[joint];
    for (size_t i = 0; i < 3; ++i)
      out[i] += weight * (m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3]);
    lack -= weight;
  }
  for (size_t i = 0; i < 3; ++i) out[i] += lack * p[i];
  return out;
}

std::vector<std::pair<size_t, double>> nonzero(const std::vector<double>& row) {
  std::vector<std::pair<size_t, double>> out;
  for (size_t j = 0; j < row.size(); ++j)
    if (row[j] > 0) out.emplace_back(j, row[j]);
  return out;
}

// Sums over the bound vertices, in the order of the file.
struct WeightSums {
  size_t vertices = 0, reference_pairs = 0, predicted_pairs = 0, common_pairs = 0;
  size_t argmax_hits = 0, bad = 0, unweighted = 0;
  double l1 = 0, kl = 0, area = 0, l1_area = 0;
};

double add_vertex(const std::vector<double>& r, const std::vector<double>& p, double area, WeightSums* sums) {
  double kl = 0, predicted_sum = 0, largest_reference = 0;
  std::vector<double> differences(r.size());
  size_t top = 0;
  for (size_t j = 0; j < r.size(); ++j) {
    const bool in_reference = r[j] > kInfluenceThreshold, in_prediction = p[j] > kInfluenceThreshold;
    sums->reference_pairs += in_reference;
    sums->predicted_pairs += in_prediction;
    sums->common_pairs += in_reference && in_prediction;
    differences[j] = std::abs(r[j] - p[j]);
    if (r[j] > 0) kl += r[j] * std::log(std::max(r[j], kLogFloor) / std::max(p[j], kLogFloor));
    predicted_sum += p[j];
    largest_reference = std::max(largest_reference, r[j]);
    if (p[j] > p[top]) top = j;
  }
  const double l1 = numpy_sum(differences.data(), differences.size());
  // A tie of the reference counts for either joint.
  if (r[top] >= largest_reference - 1e-6 && predicted_sum > 0.5) ++sums->argmax_hits;
  if (l1 > 0.5) ++sums->bad;
  if (predicted_sum < 0.5) ++sums->unweighted;
  ++sums->vertices;
  sums->l1 += l1;
  sums->kl += std::max(kl, 0.0);
  sums->area += area;
  sums->l1_area += l1 * area;
  return l1;
}

// Sum of L1 over the vertices that have reference weights.
double bound_l1(const DenseRows& reference, const DenseRows& predicted) {
  double sum = 0;
  std::vector<double> differences;
  for (size_t v = 0; v < reference.size(); ++v) {
    const std::vector<double>& r = reference[v];
    if (std::none_of(r.begin(), r.end(), [](double weight) { return weight > 0; })) continue;
    differences.resize(r.size());
    for (size_t j = 0; j < r.size(); ++j) differences[j] = std::abs(r[j] - predicted[v][j]);
    sum += numpy_sum(differences.data(), differences.size());
  }
  return sum;
}

// Rows of what was predicted, with what the reference gives to no joint of its own folded up.
void fold_rows(const std::vector<uint32_t>& targets, DenseRows* rows) {
  for (std::vector<double>& row : *rows) {
    for (size_t j = 0; j < targets.size(); ++j) {
      if (targets[j] == j || row[j] == 0) continue;
      row[targets[j]] += row[j];
      row[j] = 0;
    }
  }
}

void write_sums(const WeightSums& sums, double unfolded_l1, size_t vertex_count, Metrics* m) {
  const auto n = static_cast<double>(sums.vertices);
  m->precision = static_cast<double>(sums.common_pairs) / std::max(1.0, static_cast<double>(sums.predicted_pairs));
  m->recall = static_cast<double>(sums.common_pairs) / std::max(1.0, static_cast<double>(sums.reference_pairs));
  m->l1 = sums.l1 / n;
  m->l1_file = unfolded_l1 / n;
  m->argmax = static_cast<double>(sums.argmax_hits) / n;
  m->kl = sums.kl / n;
  m->bad = static_cast<double>(sums.bad) / n;
  m->l1_area = sums.area > 0 ? sums.l1_area / sums.area : m->l1;
  m->influences = static_cast<double>(sums.predicted_pairs) / n;
  m->unweighted = static_cast<double>(sums.unweighted) / n;
  m->vertices = vertex_count;
  m->unbound = vertex_count - sums.vertices;
}

// How far the vertices `kept` lie apart in random poses, as shares of the longest side. Returns a sum for each pose.
std::vector<double> measure_poses(const Character& reference, const std::string& name, const DenseRows& r,
                                  const DenseRows& p, const std::vector<size_t>& kept, int poses, Metrics* m) {
  const double side = longest_side(reference.vertices);
  const double scale = side > 0 ? 1 / side : 1;
  std::vector<Point3> joint_positions;
  for (const Joint& joint : reference.joints) joint_positions.push_back(scaled(joint.position, scale));
  const std::vector<std::vector<Affine>> palettes = random_poses(reference, name, joint_positions, poses);
  std::vector<double> largest(palettes.size(), 0.0);
  std::vector<double> sum_of_pose(palettes.size(), 0.0);
  double total = 0;
  for (const size_t v : kept) {
    if (r[v] == p[v]) continue;  // the same skin, distance 0
    const auto reference_row = nonzero(r[v]), predicted_row = nonzero(p[v]);
    const Point3 rest = scaled(reference.vertices[v], scale);
    for (size_t k = 0; k < palettes.size(); ++k) {
      Point3 difference = skin_point(reference_row, palettes[k], rest);
      const Point3 other = skin_point(predicted_row, palettes[k], rest);
      for (size_t i = 0; i < 3; ++i) difference[i] -= other[i];
      const double distance = length(difference);
      total += distance;
      sum_of_pose[k] += distance;
      largest[k] = std::max(largest[k], distance);
    }
  }
  for (const double d : largest) {
    m->max_dist += d / static_cast<double>(largest.size());
    m->max_dist_all = std::max(m->max_dist_all, d);
  }
  if (!palettes.empty())
    m->avg_dist = total / (static_cast<double>(kept.size()) * static_cast<double>(palettes.size()));
  return sum_of_pose;
}

}  // namespace

Metrics measure(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                const std::string& name, int poses, std::vector<float>* vertex_l1, std::vector<double>* pose_distance) {
  const size_t vertex_count = reference.vertices.size(), joint_count = reference.joints.size();
  if (reference.influences.size() != vertex_count) {
    throw Error(name + ": the reference has no weights to compare with (expected " + std::to_string(vertex_count) +
                " rows, found " + std::to_string(reference.influences.size()) + ")");
  }
  if (predicted.size() != vertex_count) {
    throw Error(name + ": the prediction has " + std::to_string(predicted.size()) + " rows, expected " +
                std::to_string(vertex_count) + ", one per vertex");
  }
  const DenseRows r = normalized_rows(reference.influences, joint_count, name);
  DenseRows p = normalized_rows(predicted, joint_count, name);
  const double unfolded_l1 = bound_l1(r, p);
  fold_rows(fold_targets(reference, r), &p);

  std::vector<size_t> kept;
  for (size_t v = 0; v < vertex_count; ++v)
    if (!nonzero(r[v]).empty()) kept.push_back(v);
  if (kept.empty()) throw Error(name + ": no vertex has reference weights to compare with");

  WeightSums sums;
  const std::vector<double> areas = vertex_areas(reference);
  if (vertex_l1) vertex_l1->assign(vertex_count, 0.0f);
  for (const size_t v : kept) {
    const double l1 = add_vertex(r[v], p[v], areas[v], &sums);
    if (vertex_l1) (*vertex_l1)[v] = static_cast<float>(l1);
  }
  Metrics m;
  write_sums(sums, unfolded_l1, vertex_count, &m);
  m.joints = joint_count;
  const std::vector<double> sum_of_pose = measure_poses(reference, name, r, p, kept, poses, &m);
  if (pose_distance) {
    pose_distance->clear();
    for (const double sum : sum_of_pose) pose_distance->push_back(sum / static_cast<double>(kept.size()));
  }
  return m;
}

namespace {

// Distances to bones of which a leaf's goes on along its parent bone: half as long, at most a tenth of the skeleton.
BoneDistance with_stubs(const Character& character) {
  BoneDistance distance(character);
  std::vector<Point3> joints;
  for (const Joint& joint : character.joints)
    joints.push_back({static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
                      static_cast<double>(joint.position.z)});
  double size = 0;
  for (size_t i = 0; i < 3; ++i) {
    const auto less = [i](const Point3& a, const Point3& b) { return a[i] < b[i]; };
    const auto [low, high] = std::minmax_element(joints.begin(), joints.end(), less);
    size = std::max(size, (*high)[i] - (*low)[i]);
  }
  for (size_t j = 0; j < joints.size(); ++j) {
    if (character.joints[j].parent < 0) continue;
    const Point3& from = joints[static_cast<size_t>(character.joints[j].parent)];
    Point3 end = joints[j];
    const double length = std::hypot(end[0] - from[0], end[1] - from[1], end[2] - from[2]);
    if (length == 0) continue;
    const double share = std::min(0.5, 0.1 * size / length);
    for (size_t i = 0; i < 3; ++i) end[i] += share * (end[i] - from[i]);
    distance.set_leaf_end(j, end);
  }
  return distance;
}

}  // namespace

std::vector<std::vector<Influence>> nearest_bone(const Character& character, const std::vector<uint8_t>& deforms) {
  const std::vector<Joint>& joints = character.joints;
  if (!deforms.empty() && deforms.size() != joints.size())
    throw Error(character.name + ": expected " + std::to_string(joints.size()) + " flags, one per joint; found " +
                std::to_string(deforms.size()));
  std::vector<uint32_t> candidates;
  for (uint32_t j = 0; j < joints.size(); ++j)
    if (deforms.empty() || deforms[j] != 0) candidates.push_back(j);
  if (candidates.empty()) throw Error(character.name + ": no joint to bind to");
  const BoneDistance distance = with_stubs(character);
  std::vector<uint32_t> depth(joints.size(), 0);
  for (size_t j = 0; j < joints.size(); ++j)
    for (int up = joints[j].parent; up >= 0 && depth[j] < joints.size(); up = joints[static_cast<size_t>(up)].parent)
      ++depth[j];
  std::vector<std::vector<Influence>> rows;
  rows.reserve(character.vertices.size());
  for (const Vec3& vertex : character.vertices) {
    uint32_t best = candidates[0];
    double least = INFINITY;
    for (const uint32_t j : candidates) {
      const double d = distance(vertex, j);
      if (d < least || (d == least && depth[j] > depth[best])) {
        least = d;
        best = j;
      }
    }
    rows.push_back({{best, 1.0f}});
  }
  return rows;
}

}  // namespace sinew
