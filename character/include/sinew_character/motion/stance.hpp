// SPDX-License-Identifier: MIT
// Motions whose rest pose is no stance: bones along one axis, joints in frames of their own, a frame of the clip. What moves tells a
// stance all the same.
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

// The same motion with another rest pose, as its own frames tell it: that of a body which stands upright, arms to its sides; of one on four legs or
// with wings its typical pose. nullopt where the rest pose is a stance already, or where nobody can tell: no frames, no left and right.
//   up  of the motion's world
std::optional<Motion> standing_motion(const Motion& motion, MaybeAxis up = {});

// A motion's frames in the world, as far as a stance is read from them, and means over them.
class MovingJoints {
 public:
  explicit MovingJoints(const Motion& motion);

  size_t frame_count() const { return poses_.size(); }
  Point3 position(size_t frame, int joint) const { return poses_[frame].positions[static_cast<size_t>(joint)]; }
  Quaternion rotation(size_t frame, int joint) const { return poses_[frame].rotations[static_cast<size_t>(joint)]; }
  const std::vector<size_t>& order() const { return tree_.parents_first; }  // parents first
  int parent(int joint) const { return motion_.joints[static_cast<size_t>(joint)].parent; }
  Point3 offset(int joint) const { return motion_.joints[static_cast<size_t>(joint)].offset; }

  // The share of frames with the largest values, at least one.
  std::vector<size_t> best_frames(double share, const std::function<double(size_t)>& value) const;
  // As seen from a joint: the mean of another's rotation, of what lies between two, and of a direction of the world.
  Quaternion mean_rotation(const std::vector<size_t>& frames, int from, int joint) const;
  Point3 mean_difference(const std::vector<size_t>& frames, int from, int first, int last) const;
  Point3 mean_direction(const std::vector<size_t>& frames, int from, const Point3& direction) const;
  // A joint that turns in no frame.
  bool is_still(int joint) const;

  // Positions of joints that are turned so in the world, with roots at the origin.
  std::vector<Point3> posed(const std::vector<Quaternion>& rotations) const;
  // The first joint from a root at which the skeleton branches.
  int trunk_root() const;
  // Joints that lie as mirror images do: siblings and what is below them, of equal counts and lengths.
  std::vector<std::pair<int, int>> mirror_pairs() const;

 private:
  void pair_below(int a, int b, std::vector<std::pair<int, int>>* pairs) const;

  const Motion& motion_;
  std::vector<WorldPose> poses_;
  JointTree tree_;
  std::vector<int> below_;       // [J] joints of the subtree
  std::vector<double> lengths_;  // [J] of its bones, the joint's own included
};

}  // namespace sinew
#endif
