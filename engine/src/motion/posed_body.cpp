// SPDX-License-Identifier: MIT
// Linear blend skinning in doubles, because contacts decide by it.
#include "motion/posed_body.hpp"

namespace sinew::motion {

bool PosedBody::allocate(Arena& arena, uint32_t vertex_count, uint32_t triangle_count, uint32_t joint_count) {
  vertices = arena.alloc<Vec3d>(vertex_count);
  middles = arena.alloc<Vec3d>(triangle_count);
  matrices = arena.alloc<double>(size_t{12} * joint_count);
  return arena.ok();
}

void PosedBody::measure(Vec3d up) {
  double highest = 0;
  for (uint32_t v = 0; v < body->vertex_count; ++v) {
    const double own = dot(up, rotate(rotation, rest(v)));
    if (v == 0 || own < lowest) lowest = own;
    if (v == 0 || own > highest) highest = own;
  }
  height = highest - lowest;
}

void PosedBody::take_pose(const Quat* rotations, const Vec3d* positions) {
  for (uint32_t j = 0; j < rig->count; ++j) {
    // The body's world rotation, then the joint's rotation in the other.
    const Quat q = rotations[j] * rotation;
    const Vec3d columns[3] = {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1})};
    const Vec3d offset = positions[j] - rotate(q, rig->positions[j]);
    double* const m = matrices + size_t{12} * j;
    for (int c = 0; c < 3; ++c) {
      m[c] = columns[c].x;
      m[4 + c] = columns[c].y;
      m[8 + c] = columns[c].z;
    }
    m[3] = offset.x;
    m[7] = offset.y;
    m[11] = offset.z;
  }
}

Vec3d PosedBody::skinned(uint32_t v) const {
  const uint32_t slots = body->skin.influence_count;
  const uint16_t* const row = weights_of(*body) + size_t{slots} * v;
  const uint16_t* const joints = body->skin.joint_indices + size_t{slots} * v;
  const Vec3d p = rest(v);
  double sum[12] = {};
  const double* m = sum;
  if (row[0] == 65535) {
    m = matrices + size_t{12} * joints[0];
  } else {
    for (uint32_t i = 0; i < slots; ++i) {
      if (row[i] == 0) continue;
      const double share = static_cast<double>(row[i]) * (1.0 / 65535.0);
      const double* const joint = matrices + size_t{12} * joints[i];
      for (int e = 0; e < 12; ++e) sum[e] += share * joint[e];
    }
  }
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
          m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

void PosedBody::pose(const Quat* rotations, const Vec3d* positions) {
  take_pose(rotations, positions);
  for (uint32_t v = 0; v < body->vertex_count; ++v) vertices[v] = skinned(v);
}

void PosedBody::find_middles(const uint32_t* triangles, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t* const corner = triangles + size_t{3} * i;
    middles[i] = (1.0 / 3.0) * (vertices[corner[0]] + vertices[corner[1]] + vertices[corner[2]]);
  }
}

sinew_status check_body(const sinew_motion_body& body, uint32_t joint_count) {
  if (body.positions == nullptr || body.skin.joint_indices == nullptr || body.skin.weights == nullptr ||
      body.skin.weight_format != SINEW_WEIGHT_UNORM16 || (body.triangle_count > 0 && body.triangles == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (body.vertex_count == 0 || body.vertex_count > SINEW_MAX_VERTICES || body.skin.influence_count == 0 ||
      body.skin.influence_count > SINEW_MAX_INFLUENCES || body.triangle_count > kMostTriangles) {
    return SINEW_ERROR_COUNT;
  }
  for (size_t i = 0; i < size_t{3} * body.vertex_count; ++i) {
    if (!is_finite(static_cast<double>(body.positions[i]))) return SINEW_ERROR_NOT_FINITE;
  }
  for (size_t i = 0; i < size_t{body.skin.influence_count} * body.vertex_count; ++i) {
    if (body.skin.joint_indices[i] >= joint_count) return SINEW_ERROR_RANGE;
  }
  for (size_t i = 0; i < size_t{3} * body.triangle_count; ++i) {
    if (body.triangles[i] >= body.vertex_count) return SINEW_ERROR_INDEX;
  }
  return SINEW_OK;
}

}  // namespace sinew::motion
