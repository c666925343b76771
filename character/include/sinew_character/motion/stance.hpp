// SPDX-License-Identifier: MIT
// Motions whose rest pose is not a standing pose: bones along one axis, joints with their own axes, or a frame of the
// clip. A standing pose is estimated from the frames.
#ifndef SINEW_CHARACTER_STANCE_HPP
#define SINEW_CHARACTER_STANCE_HPP

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Returns the motion with a rest pose estimated from its frames: standing upright, arms at the sides; for bodies on
// four legs or with wings the typical pose. Returns nullopt if the rest pose is a standing pose already, or if it
// cannot be estimated (no frames, or no left and right).
//   up  of the motion's world
std::optional<Motion> standing_motion(const Motion& motion, MaybeAxis up = {});

// World poses of a motion's frames and their means, for estimating a standing pose.
class MovingJoints {
 public:
  explicit MovingJoints(const Motion& motion);

  size_t frame_count() const { return poses_.size(); }
  Point3 position(size_t frame, int joint) const { return poses_[frame].positions[static_cast<size_t>(joint)]; }
  Quaternion rotation(size_t frame, int joint) const { return poses_[frame].rotations[static_cast<size_t>(joint)]; }
  const std::vector<size_t>& order() const { return tree_.parents_first; }  // parents first
  int parent(int joint) const { return motion_.joints[static_cast<size_t>(joint)].parent; }
  Point3 offset(int joint) const { return motion_.joints[static_cast<size_t>(joint)].offset; }

  // Returns this share of frames with the largest values, at least one.
  std::vector<size_t> best_frames(double share, const std::function<double(size_t)>& value) const;
  // Means relative to a joint: of another joint's rotation, of the vector between two joints, and of a world
  // direction.
  Quaternion mean_rotation(const std::vector<size_t>& frames, int from, int joint) const;
  Point3 mean_difference(const std::vector<size_t>& frames, int from, int first, int last) const;
  Point3 mean_direction(const std::vector<size_t>& frames, int from, const Point3& direction) const;
  // Returns whether a joint rotates in no frame.
  bool is_still(int joint) const;

  // Returns positions of joints with these world rotations, with roots at the origin.
  std::vector<Point3> posed(const std::vector<Quaternion>& rotations) const;
  // Returns the first joint from a root at which the skeleton branches.
  int trunk_root() const;
  // Returns mirrored joints: siblings and their descendants with equal counts and lengths.
  std::vector<std::pair<int, int>> mirror_pairs() const;

 private:
  void pair_below(int a, int b, std::vector<std::pair<int, int>>* pairs) const;

  const Motion& motion_;
  std::vector<WorldPose> poses_;
  JointTree tree_;
  std::vector<int> below_;       // [J] joints of the subtree
  std::vector<double> lengths_;  // [J] of its bones, including the joint's own
};

}  // namespace sinew
#endif
