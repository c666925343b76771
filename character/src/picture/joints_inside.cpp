// SPDX-License-Identifier: MIT
// The silhouette of a picture's mesh, and what joints do by it.
#include "picture/joints_inside.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sinew/rig.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The outline of a picture's mesh: the edges between its front and its back.

using Run = std::pair<float, float>;  // from x to x

class Silhouette {
 public:
  explicit Silhouette(const Character& mesh) : mesh_(mesh) {}
  // Where a level line is inside, from left to right.
  std::vector<Run> at(float y) const;
  bool has(float x, float y) const;

 private:
  const Character& mesh_;
};

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

namespace {

// How much nearer a point counts for its depth. Chosen on every twelfth training character, drawn: of 1, 1.2, 1.5 and 2 none moved a joint for the worse.
constexpr float kDeep = 1.5f;

using RimEdge = std::pair<const Vec3*, const Vec3*>;

// Edges of two vertices of the outline: its own, and the chords between. Those are no nearer than what they part.
std::vector<RimEdge> rim_of(const Character& mesh) {
  std::vector<RimEdge> rim;
  for (size_t f = 0; f < mesh.face_count(); ++f)
    for (size_t c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) {
      const size_t next = c + 1 < mesh.face_offsets[f + 1] ? c + 1 : mesh.face_offsets[f];
      const Vec3 &a = mesh.vertices[mesh.face_vertices[c]], &b = mesh.vertices[mesh.face_vertices[next]];
      if (a.z == 0 && b.z == 0) rim.push_back({&a, &b});
    }
  return rim;
}

float distance_to(const RimEdge& edge, const Vec3& p) {
  const float dx = edge.second->x - edge.first->x, dy = edge.second->y - edge.first->y;
  const float px = p.x - edge.first->x, py = p.y - edge.first->y, square = dx * dx + dy * dy;
  const float along = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0f, 1.0f) : 0;
  return std::hypot(px - along * dx, py - along * dy);
}

struct InnerPoint {
  const Vec3* position;
  float depth;  // from the outline
};

std::vector<InnerPoint> inner_of(const Character& mesh) {
  const std::vector<RimEdge> rim = rim_of(mesh);
  std::vector<InnerPoint> inner;
  for (const Vec3& v : mesh.vertices) {
    if (v.z <= 0) continue;
    float depth = 1e9f;
    for (const RimEdge& edge : rim) depth = std::min(depth, distance_to(edge, v));
    inner.push_back({&v, depth});
  }
  return inner;
}

}  // namespace

void move_joints_inside(const Character& mesh, PredictedSkeleton* skeleton) {
  const Silhouette silhouette(mesh);
  std::vector<InnerPoint> inner;
  for (Joint& joint : skeleton->joints) {
    Vec3& position = joint.position;
    if (silhouette.has(position.x, position.y)) continue;
    if (inner.empty()) inner = inner_of(mesh);
    const auto cost = [&](const InnerPoint& one) {
      return std::hypot(one.position->x - position.x, one.position->y - position.y) - kDeep * one.depth;
    };
    const auto best = std::min_element(inner.begin(), inner.end(),
                                       [&](const InnerPoint& a, const InnerPoint& b) { return cost(a) < cost(b); });
    if (best != inner.end()) position = {best->position->x, best->position->y, position.z};
  }
}

namespace {

// The two runs on both sides of `x`, or one of them around it and the nearest other one, no farther than `reach`.
std::optional<std::pair<Run, Run>> two_beside(const std::vector<Run>& runs, float x, float reach) {
  std::vector<Run> near;
  for (const Run& run : runs)
    if (run.second > x - reach && run.first < x + reach) near.push_back(run);
  if (near.size() < 2) return std::nullopt;
  std::sort(near.begin(), near.end(), [x](const Run& a, const Run& b) {
    return std::abs(a.first + a.second - 2 * x) < std::abs(b.first + b.second - 2 * x);
  });
  if (near[0] > near[1]) std::swap(near[0], near[1]);
  return std::pair{near[0], near[1]};
}

bool is_limb(uint8_t c) {
  return (c >= SINEW_CLASS_UPPER_ARM && c <= SINEW_CLASS_HAND) || (c >= SINEW_CLASS_THIGH && c <= SINEW_CLASS_TOE);
}

}  // namespace

void part_side_limbs(const Character& mesh, PredictedSkeleton* skeleton) {
  const Silhouette silhouette(mesh);
  const float size = box_of(mesh.vertices).longest_side();
  std::vector<Joint>& joints = skeleton->joints;
  for (size_t left = 0; left < joints.size(); ++left) {
    if (!is_limb(skeleton->classes[left]) || joints[left].name.rfind("Left", 0) != 0) continue;
    const std::string other = "Right" + joints[left].name.substr(4);
    const auto right = std::find_if(joints.begin(), joints.end(), [&](const Joint& j) { return j.name == other; });
    if (right == joints.end()) continue;
    Vec3 &a = joints[left].position, &b = right->position;
    if (std::hypot(a.x - b.x, a.y - b.y) > 0.02f * size) continue;
    const auto runs = two_beside(silhouette.at(a.y), a.x, 0.12f * size);
    if (!runs) continue;
    // No leg is much wider than the other.
    const float first = runs->first.second - runs->first.first, second = runs->second.second - runs->second.first;
    if (first > 2.5f * second || second > 2.5f * first) continue;
    a.x = 0.5f * (runs->first.first + runs->first.second);
    b.x = 0.5f * (runs->second.first + runs->second.second);
  }
}

void take_forks_off(PredictedSkeleton* skeleton) {
  const std::vector<Joint>& joints = skeleton->joints;
  const size_t count = joints.size();
  std::vector<size_t> below(count, 1);  // joints of a branch; parents come first
  for (size_t j = count; j-- > 0;)
    if (joints[j].parent >= 0) below[static_cast<size_t>(joints[j].parent)] += below[j];
  std::vector<uint8_t> gone(count, 0);
  std::vector<int> kept_child(count, -1);
  for (size_t j = 0; j < count; ++j) {
    const uint8_t c = skeleton->classes[j];
    if (joints[j].parent < 0 || skeleton->ends[j] != 0 || !is_limb(c)) continue;
    const auto parent = static_cast<size_t>(joints[j].parent);
    const uint8_t above = skeleton->classes[parent];
    if (!is_limb(above) || above == SINEW_CLASS_HAND || above == SINEW_CLASS_FOOT || above == SINEW_CLASS_TOE) continue;
    int& kept = kept_child[parent];
    if (kept >= 0) gone[below[j] > below[static_cast<size_t>(kept)] ? static_cast<size_t>(kept) : j] = 1;
    if (kept < 0 || gone[static_cast<size_t>(kept)] != 0) kept = static_cast<int>(j);
  }
  std::vector<int> numbers(count, -1);
  PredictedSkeleton out = *skeleton;
  out.joints.clear(), out.classes.clear(), out.ends.clear(), out.partners.clear();
  out.confidence.clear(), out.parent_confidence.clear();
  for (size_t j = 0; j < count; ++j) {
    const int parent = joints[j].parent;
    if (parent >= 0 && gone[static_cast<size_t>(parent)] != 0) gone[j] = 1;
    if (gone[j] != 0) continue;
    numbers[j] = static_cast<int>(out.joints.size());
    out.joints.push_back(joints[j]);
    out.joints.back().parent = parent >= 0 ? numbers[static_cast<size_t>(parent)] : -1;
    out.classes.push_back(skeleton->classes[j]);
    out.ends.push_back(skeleton->ends[j]);
    out.partners.push_back(skeleton->partners[j]);
    out.confidence.push_back(skeleton->confidence[j]);
    out.parent_confidence.push_back(skeleton->parent_confidence[j]);
  }
  for (int32_t& partner : out.partners)
    if (partner >= 0) partner = numbers[static_cast<size_t>(partner)];
  *skeleton = std::move(out);
}

}  // namespace sinew
