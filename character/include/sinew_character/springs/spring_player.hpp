// SPDX-License-Identifier: MIT
// Simulates springs of a character's joints frame by frame in the engine, with an additional joint for the end of
// each chain.
#ifndef SINEW_CHARACTER_SPRING_PLAYER_HPP
#define SINEW_CHARACTER_SPRING_PLAYER_HPP

#include <string>
#include <vector>

#include "sinew/sinew.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {

class SpringPlayer {
 public:
  // motion  has the joints of `springs`; its clips are ignored
  // Throws Error if there are no chains or the engine rejects them.
  SpringPlayer(const Springs& springs, const Motion& motion);

  // Rotates the chains' joints in the next frame of a motion, `seconds` after the last one, see
  // sinew_springs_frame(). Throws Error.
  void frame(double seconds, MotionFrame* pose);
  // Number of joints that frame() rotates.
  const std::vector<size_t>& joints() const { return turning_; }

 private:
  void check(sinew_status status) const;
  void add_joint(const Point3& position, int parent);
  void add_head(const SpringJoint& joint);
  void read(const Springs& springs, const std::vector<Joint>& joints);

  std::string name_;
  size_t joint_count_;
  std::vector<float> positions_;  // of the skeleton and the chains' ends
  std::vector<int32_t> parents_;
  std::vector<sinew_spring_joint> heads_;
  std::vector<float> hinges_;  // [heads x 3]
  std::vector<sinew_spring_chain> chains_;
  std::vector<sinew_spring_collider> colliders_;
  std::vector<uint32_t> chain_colliders_;
  std::vector<size_t> turning_;
  std::vector<Point3> ends_;  // of chains, after the motion's joints
  std::vector<float> rotations_, translations_;
  SpringSystem springs_;
};

}  // namespace sinew
#endif
