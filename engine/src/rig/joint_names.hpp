// SPDX-License-Identifier: MIT
// Names of predicted joints, as humanoid rigs have them: Hips, Spine, Spine1, LeftArm, LeftForeArm, Head_end.
#ifndef SINEW_RIG_JOINT_NAMES_HPP
#define SINEW_RIG_JOINT_NAMES_HPP

#include "rig/rig_joint.hpp"

namespace sinew::rigging {

constexpr uint32_t kMaxJointName = 32;  // bytes, with the 0 at the end

// A name of its class, with Left (+x) or Right where it has a partner on the other side; of joints that nothing is
// mirrored for, those of paired classes and wings have sides. The second of a name, in the joints' order, is numbered
// 1. A bone end is its joint's name and _end. No name comes twice.
//   joints  in   [count] parents before children, count <= kMaxRigJoints
//   names   out  [count]
void name_joints(const RigJoint* joints, uint32_t count, char (*names)[kMaxJointName]);

}  // namespace sinew::rigging
#endif
