// SPDX-License-Identifier: MIT
// The plane between a predicted skeleton's sides, which may face anywhere about its up axis.
#ifndef SINEW_CHARACTER_PREDICT_MIRROR_PLANE_HPP
#define SINEW_CHARACTER_PREDICT_MIRROR_PLANE_HPP

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_character/rig/joint_mirror.hpp"

namespace sinew {

class MirrorPlane {
 public:
  explicit MirrorPlane(const PredictedSkeleton& skeleton) : at_(skeleton.plane) {
    // Across the front, with positive x, as sinew_rig_outputs has it.
    const bool z_up = skeleton.up_axis == Axis::kZ;
    const float x = z_up ? -skeleton.front[1] : skeleton.front[2], z = -skeleton.front[0];
    const float sign = x < 0 || (x == 0 && z < 0) ? -1.0f : 1.0f;
    normal_ = z_up ? Vec3{sign * x, -sign * z, 0} : Vec3{sign * x, 0, sign * z};
    along_axis_ = z == 0 || (x == 0 && !z_up);
    axis_ = z == 0 ? 0 : 2;
  }
  float distance(const Vec3& p) const {
    if (along_axis_) return component(p, axis_) - at_;
    return normal_.x * p.x + normal_.y * p.y + normal_.z * p.z - at_;
  }
  Vec3 image(const Vec3& p) const { return along_axis_ ? mirrored(p, axis_, at_) : moved(p, -2 * distance(p)); }
  void move_there(Vec3* p) const {
    if (along_axis_) {
      component(p, axis_) = at_;
    } else {
      *p = moved(*p, -distance(*p));
    }
  }

 private:
  Vec3 moved(const Vec3& p, float way) const {
    return {p.x + way * normal_.x, p.y + way * normal_.y, p.z + way * normal_.z};
  }

  Vec3 normal_{};
  float at_;
  uint32_t axis_ = 0;
  bool along_axis_ = true;
};

}  // namespace sinew
#endif
