// SPDX-License-Identifier: MIT
// Random poses and proportions of a character that skeletons are learned from.
#ifndef SINEW_TRAINER_DATA_RIG_POSE_HPP
#define SINEW_TRAINER_DATA_RIG_POSE_HPP

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "sinew_data_sets/target_skeleton.hpp"

namespace sinew {

// A target skeleton in its mirror frame: +x left, +y up, +z where it faces; shares of the longest side, the floor at y = 0.
struct PoseBody {
  TargetSkeleton target;
  std::vector<std::array<double, 3>> joints;  // [target]
  std::vector<std::vector<uint32_t>> kids;    // [target]
  std::vector<int> partner;                   // [target] mirror image or -1

  // Joints that are no bone ends; they come first.
  size_t bones() const;
  // From a joint to the middle of its children; 0 without any.
  Eigen::Vector3d direction(size_t joint) const;
};

struct RigPose {
  bool symmetric = true;  // partners mirror each other
  // [bones]
  std::vector<Eigen::Vector3d> turn;           // axis times angle, on top of the parent's rotation
  std::vector<std::array<double, 2>> stretch;  // logarithms, along the bone and across
  std::vector<Eigen::Vector3d> aim;  // where the bone points afterwards, whatever its parent does; 0: as `turn` says
};

// strength 1: joints rotate by up to a radian, 0: none does. Seven in ten are symmetric.
RigPose mild_pose(const PoseBody& body, double strength, Random* random);
// As meshes of strangers stand: three quarters are not symmetric, joints rotate twice as far; two in five have their
// arms along the body, as many their legs walking, galloping or sitting, one in five is a toy with a large head and
// short limbs. Some animals sit or lie, some people have their hands on the hips, in the pockets or across the chest,
// some wings are folded, some tails curled.
RigPose wide_pose(const PoseBody& body, double strength, Random* random);

}  // namespace sinew
#endif
