// SPDX-License-Identifier: MIT
// A joint of a predicted skeleton.
#ifndef SINEW_RIG_RIG_JOINT_HPP
#define SINEW_RIG_RIG_JOINT_HPP

#include "core/fixed.hpp"

namespace sinew::rigging {

constexpr uint32_t kMaxFoldedJoints = 48;                 // on the plane and on one side of it
constexpr uint32_t kMaxRigJoints = 4 * kMaxFoldedJoints;  // both sides, and every joint's bone end

// Parents come before their children; joint 0 is the root.
struct RigJoint {
  Vec3i position;              // grid units in the mirror frame
  int16_t parent;              // -1 for the root
  int16_t partner;             // its mirror image, itself on the plane, -1 where it has none
  uint8_t joint_class;         // JointClass; a bone end's is its joint's
  uint8_t tip;                 // 1 for a bone end
  uint16_t confidence;         // Q15: how sure the votes are of the joint's position
  uint16_t parent_confidence;  // Q15: how sure they are of its parent
  int8_t side;                 // 1 left, -1 right, 0: its position says
};

constexpr uint32_t kMaxJointName = 32;  // bytes, with the 0 at the end

// Names of predicted joints, as humanoid rigs have them: Hips, Spine, Spine1, LeftArm, LeftForeArm, Head_end.
// A name of its class, with Left (+x) or Right where it has a partner on the other side; of joints that nothing is
// mirrored for, those of paired classes and wings have sides. The second of a name, in the joints' order, is numbered
// 1. A bone end is its joint's name and _end. No name comes twice.
//   joints  in   [count] parents before children, count <= kMaxRigJoints
//   names   out  [count]
void name_joints(const RigJoint* joints, uint32_t count, char (*names)[kMaxJointName]);

}  // namespace sinew::rigging
#endif
