// SPDX-License-Identifier: MIT
// Pairs of a step that shrinks and one that inflates.
#include "published/bend_smoothing.hpp"

namespace sinew::deform {
namespace {

constexpr int kSteps = 2;
constexpr double kInflates = 1.15;  // of the step before
constexpr int kInflations = 2;
constexpr uint32_t kMostBendSweeps = 32;
constexpr double kMostInflation = 0.5;  // of a cell, for a whole share
constexpr double kMostShare = 0.5;
constexpr double kLeastShare = 1e-4;  // below it is rounding: nothing bends

// The joint of a row that shares most with what its parent moves with, if it moves against that.
uint32_t bend_of(const PosedJoints& posed, uint32_t v) {
  const DeformRest& rest = *posed.rest;
  const size_t at = static_cast<size_t>(v) * rest.influence_count;
  uint32_t best = rest.joint_count;
  double most = 0;
  for (uint32_t i = 0; i < rest.influence_count; ++i) {
    // The top of what moves with the joint as one piece.
    const uint32_t joint = posed.joints[rest.joints[at + i]].group;
    const int32_t parent = rest.skeleton[joint].parent;
    if (rest.weights[at + i] == 0 || parent < 0) continue;
    double own = 0, above = 0;
    for (uint32_t k = 0; k < rest.influence_count; ++k) {
      const uint32_t group = posed.joints[rest.joints[at + k]].group;
      if (group == joint) own += rest.weights[at + k];
      if (group == posed.joints[parent].group) above += rest.weights[at + k];
    }
    if (own * above <= most) continue;
    most = own * above;
    best = joint;
  }
  return best;
}

// 1 minus the blended quaternion's length squared is the squared sine of about half the angle between the joints.
SmoothedVertex begin_vertex(const PosedJoints& posed, uint32_t u, Vec3d position) {
  const DeformRest& rest = *posed.rest;
  const uint32_t n = rest.influence_count, v = rest.first[u];
  const size_t at = static_cast<size_t>(v) * n;
  const DualQuaternion blended = blend_motions(posed, rest.joints + at, rest.weights + at, n, rest.position(v));
  const double square = dot(blended.real, blended.real);
  double whole = 0;
  for (uint32_t i = 0; i < n; ++i) whole += rest.weights[at + i];
  const double share = whole > 0 ? root(clamped(1 - square / (whole * whole), 0, 1)) : 0;
  return {reciprocal_root(square) * blended.real,
          share < kLeastShare ? 0 : lesser(share, kMostShare),
          position,
          position,
          share < kLeastShare ? rest.joint_count : bend_of(posed, v),
          {0, 0, 0}};
}

// Vertices that the lattice moved around a bend belong to it.
void grow_bends(const DeformRest& rest, const uint8_t* moved, SmoothedVertex* vertices) {
  bool more = true;
  for (uint32_t sweep = 0; more && sweep < kMostBendSweeps; ++sweep) {
    more = false;
    for (uint32_t i = 0; i < rest.welded_count; ++i) {
      const uint32_t u = sweep % 2 == 0 ? i : rest.welded_count - 1 - i;
      if (moved[u] == 0 || vertices[u].joint != rest.joint_count) continue;
      for (uint32_t r = rest.row_offsets[u]; r < rest.row_offsets[u + 1]; ++r) {
        const uint32_t joint = vertices[rest.col_indices[r]].joint;
        if (joint == rest.joint_count) continue;
        vertices[u].joint = joint;
        more = true;
        break;
      }
    }
  }
}

// One step of all bends along their normals.
void inflate(const PosedJoints& posed, SmoothedVertex* vertices, BendVolume* volumes) {
  const DeformRest& rest = *posed.rest;
  const double most = kMostInflation * rest.unit * kCellUnits;
  for (uint32_t j = 0; j < rest.joint_count; ++j) volumes[j] = {0, 0, 0};
  for (uint32_t u = 0; u < rest.welded_count; ++u) vertices[u].normal = {0, 0, 0};
  for (uint32_t t = 0; t < rest.triangle_count; ++t) {
    const uint32_t* const at = rest.triangles + 3 * static_cast<size_t>(t);
    uint32_t joint = rest.joint_count;
    for (int k = 0; k < 3 && joint == rest.joint_count; ++k) joint = vertices[at[k]].joint;
    if (joint == rest.joint_count) continue;
    const Vec3d center = rest.skeleton[joint].position, moved = move(posed.joints[joint].motion, center);
    const Vec3d a = vertices[at[0]].position - moved, b = vertices[at[1]].position - moved,
                c = vertices[at[2]].position - moved;
    const Vec3d a0 = rest.position(rest.first[at[0]]) - center, b0 = rest.position(rest.first[at[1]]) - center,
                c0 = rest.position(rest.first[at[2]]) - center;
    volumes[joint].at_rest += dot(a0, cross(b0, c0));
    volumes[joint].now += dot(a, cross(b, c));
    const Vec3d normal = cross(b - a, c - a);
    for (int k = 0; k < 3; ++k) vertices[at[k]].normal = vertices[at[k]].normal + normal;
  }
  for (uint32_t u = 0; u < rest.welded_count; ++u) {
    const SmoothedVertex& own = vertices[u];
    if (own.joint != rest.joint_count) volumes[own.joint].area += own.share * length(own.normal);
  }
  for (uint32_t u = 0; u < rest.welded_count; ++u) {
    SmoothedVertex& own = vertices[u];
    if (own.joint == rest.joint_count) continue;
    const BendVolume& volume = volumes[own.joint];
    const double lacks = volume.at_rest - volume.now;
    if (!(volume.area > 0)) continue;
    own.position = own.position + (own.share * clamped(lacks / volume.area, -most, most)) * unit(own.normal);
  }
}

}  // namespace

void smooth_bends(const PosedJoints& posed, const uint8_t* moved, SmoothedVertex* vertices, BendVolume* volumes,
                  Vec3d* positions) {
  const DeformRest& rest = *posed.rest;
  for (uint32_t u = 0; u < rest.welded_count; ++u) vertices[u] = begin_vertex(posed, u, positions[rest.first[u]]);
  const bool as_drawn = rest.options.as_drawn != 0;
  for (int step = 0; step < (as_drawn ? 1 : kSteps); ++step) {
    for (uint32_t u = 0; u < rest.welded_count; ++u) {
      SmoothedVertex& own = vertices[u];
      const uint32_t begin = rest.row_offsets[u], end = rest.row_offsets[u + 1];
      own.next = own.position;
      if (!(own.share > 0) || begin == end) continue;
      Vec3d sum = {0, 0, 0}, sum_at_rest = {0, 0, 0};
      for (uint32_t r = begin; r < end; ++r) {
        const uint32_t other = rest.col_indices[r];
        sum = sum + (vertices[other].position - own.position);
        sum_at_rest = sum_at_rest + (rest.position(rest.first[other]) - rest.position(rest.first[u]));
      }
      const double share = step % 2 == 0 ? own.share : -kInflates * own.share;
      const Vec3d back = as_drawn ? Vec3d{0, 0, 0} : rotate(own.rotation, sum_at_rest);
      own.next = own.position + (share / (end - begin)) * (sum - back);
    }
    for (uint32_t u = 0; u < rest.welded_count; ++u) vertices[u].position = vertices[u].next;
  }
  if (!as_drawn) grow_bends(rest, moved, vertices);
  for (int step = 0; step < kInflations && !as_drawn; ++step) inflate(posed, vertices, volumes);
  for (uint32_t v = 0; v < rest.vertex_count; ++v) {
    const SmoothedVertex& own = vertices[rest.welded[v]];
    if (own.share > 0) positions[v] = own.position;
  }
}

}  // namespace sinew::deform
