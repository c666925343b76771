// SPDX-License-Identifier: MIT
// A body in a pose: its skinned vertices and the middles and normals of its triangles.
#ifndef SINEW_MOTION_POSED_BODY_HPP
#define SINEW_MOTION_POSED_BODY_HPP

#include "core/arena.hpp"
#include "motion/motion_rig.hpp"

namespace sinew::motion {

constexpr uint32_t kMostTriangles = 8u * SINEW_MAX_VERTICES;  // of a body

struct PosedBody {
  const sinew_motion_body* body = nullptr;
  const MotionRig* rig = nullptr;
  Quat rotation = kNoRotation;    // from the body's world to the one that it is posed in
  Vec3d* vertices = nullptr;      // [vertices]
  Vec3d* middles = nullptr;       // [triangles]
  double* matrices = nullptr;     // [joints x 12]
  double lowest = 0, height = 0;  // at rest, along `up`

  bool allocate(Arena& arena, uint32_t vertex_count, uint32_t triangle_count, uint32_t joint_count);
  // After the members above: measures the rest pose.
  void measure(Vec3d up);
  // By rotates against the rest pose and positions [joints], both in the world that it is posed in: for skinned() alone, or with all
  // vertices.
  void take_pose(const Quat* rotations, const Vec3d* positions);
  void pose(const Quat* rotations, const Vec3d* positions);
  // One vertex in the pose.
  Vec3d skinned(uint32_t v) const;
  // With pose(): middles of triangles.
  void find_middles(const uint32_t* triangles, uint32_t count);
  // With pose(), of length 1, or 0.
  Vec3d normal(const uint32_t* corner) const {
    const Vec3d a = vertices[corner[0]];
    return unit(cross(vertices[corner[1]] - a, vertices[corner[2]] - a));
  }

  Vec3d rest(uint32_t v) const {
    const float* const p = body->positions + size_t{3} * v;
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }
};

inline const uint16_t* weights_of(const sinew_motion_body& body) {
  return static_cast<const uint16_t*>(body.skin.weights);
}
// The joint that a vertex has most of; of equal ones the first of its row.
inline uint32_t heaviest_joint(const sinew_motion_body& body, uint32_t v) {
  const size_t first = size_t{body.skin.influence_count} * v;
  size_t best = first;
  for (size_t i = first + 1; i < first + body.skin.influence_count; ++i)
    if (weights_of(body)[i] > weights_of(body)[best]) best = i;
  return body.skin.joint_indices[best];
}
// Counts, indices and numbers of a body. SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_COUNT, SINEW_ERROR_RANGE for a joint
// that does not exist, SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX for a triangle's vertex.
sinew_status check_body(const sinew_motion_body& body, uint32_t joint_count);

}  // namespace sinew::motion
#endif
