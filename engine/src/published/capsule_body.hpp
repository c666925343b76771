// SPDX-License-Identifier: MIT
// Bodies of capsules around the two skeletons of a plan, for motions that have no mesh: the same capsules with the same triangles round
// both. The source's are as thick as limbs of such length are, the target's (ours) as thick as its mesh is there.
#ifndef SINEW_PUBLISHED_CAPSULE_BODY_HPP
#define SINEW_PUBLISHED_CAPSULE_BODY_HPP

#include "motion/retarget_plan.hpp"

namespace sinew::motion {

class CapsuleBodies {
 public:
  // A capsule: rings of kSides vertices and a pole at each end.
  static constexpr uint32_t kSides = 8, kRings = 3, kVertices = kSides * kRings + 2,
                            kTriangles = 2 * kSides * (kRings - 1) + 2 * kSides;
  // One for the bone above every joint, one beyond every leaf.
  static uint32_t capacity(uint32_t target_joints) { return 2 * target_joints; }

  bool allocate(Arena& arena, uint32_t target_joints);
  // Capsules of bones between mapped joints of the body, without fingers and toes. source() and target() have no
  // vertices where there are none.
  //   mesh  the target's
  void build(const sinew_retarget& plan, const sinew_motion_body& mesh);

  sinew_motion_body source() const { return view(source_positions_, source_joints_); }
  sinew_motion_body target() const { return view(target_positions_, target_joints_); }

 private:
  struct Bone {
    Vec3d from, to;
    double radius;
    uint16_t joint;
  };
  sinew_motion_body view(const float* positions, const uint16_t* joints) const;
  void find_bones(const sinew_retarget& plan);
  void measure_target(const sinew_motion_body& mesh);
  void add(const Bone& source, const Bone& target, const Quat& source_world);

  uint32_t bone_count_ = 0, count_ = 0;
  Bone *source_bones_ = nullptr, *target_bones_ = nullptr;
  double* sums_ = nullptr;  // [capacity] distances of the mesh's vertices from the bone
  uint32_t* counts_ = nullptr;
  float *source_positions_ = nullptr, *target_positions_ = nullptr;
  uint16_t *source_joints_ = nullptr, *target_joints_ = nullptr, *weights_ = nullptr;
  uint32_t* triangles_ = nullptr;
};

}  // namespace sinew::motion
#endif
