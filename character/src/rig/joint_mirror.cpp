// SPDX-License-Identifier: MIT
// Sides and mirror images, as the engine finds them.
#include "sinew_character/rig/joint_mirror.hpp"

#include <utility>

#include "sinew_character/rig/joint_verdicts.hpp"

namespace sinew {

float& component(Vec3* p, uint32_t axis) { return axis == 0 ? p->x : axis == 1 ? p->y : p->z; }
float component(const Vec3& p, uint32_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

Vec3 mirrored(const Vec3& p, uint32_t axis, float plane) {
  Vec3 image = p;
  component(&image, axis) = 2 * plane - component(p, axis);
  return image;
}

Side side_of_name(const std::string& name) { return static_cast<Side>(sinew_joint_side(name.c_str())); }

std::string other_side_name(const std::string& name) {
  std::string other(name.size() + 8, 0);
  if (sinew_joint_side(name.c_str()) == 0 ||
      sinew_joint_other_side(name.c_str(), other.data(), other.size()) != SINEW_OK)
    return name;
  other.resize(other.find('\0'));
  return other;
}

float mirror_plane(const std::vector<Joint>& joints, uint32_t axis) {
  return joint_verdicts(joints).mirror_planes[axis];
}

JointMirror find_joint_mirror(const std::vector<Joint>& joints) {
  JointVerdicts verdicts = joint_verdicts(joints);
  return {verdicts.mirrored, verdicts.mirror_axis, verdicts.mirror_planes[verdicts.mirror_axis],
          std::move(verdicts.images)};
}

}  // namespace sinew
