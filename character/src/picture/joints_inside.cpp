// SPDX-License-Identifier: MIT
#include "picture/joints_inside.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "picture/silhouette.hpp"

namespace sinew {
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

}  // namespace sinew
