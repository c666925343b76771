// SPDX-License-Identifier: MIT
// The mean of a motion's poses, upright and its own mirror image: a stance of bodies of any kind.
#ifndef SINEW_CHARACTER_MOTION_TYPICAL_POSE_HPP
#define SINEW_CHARACTER_MOTION_TYPICAL_POSE_HPP

#include <utility>
#include <vector>

#include "sinew_character/motion/stance.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {

using MirrorPairs = std::vector<std::pair<int, int>>;

// How far mirror images are off, of the mean distance from their middle, for the best plane between them; 1 where they lie together.
double asymmetry(const MirrorPairs& pairs, const std::vector<Point3>& positions);

// Whether nearly all bones lie along one direction, as in files whose joints have their bones along x: no body with limbs is at rest so.
bool is_in_one_line(const std::vector<MotionJoint>& joints);

// [J] rotations in the world: the mean over the tallest of the frames in which the torso stands as it mostly does.
//   pairs  mirror images, parents first
//   up     of the motion's world, a unit vector
std::vector<Quaternion> typical_pose(const MovingJoints& moving, const MirrorPairs& pairs, const Point3& up);

}  // namespace sinew
#endif
