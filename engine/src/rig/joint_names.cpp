// SPDX-License-Identifier: MIT
// Class, side and number of a joint as text.
#include "names/standard_names.hpp"
#include "rig/rig_joint.hpp"
#include "votes/joint_class.hpp"

namespace sinew::rigging {
namespace {

enum Side : int8_t { kNoSide = 0, kLeft = 1, kRight = -1 };

Side side_of(const RigJoint& joint, uint32_t index) {
  const bool mirrored = joint.partner >= 0;
  const bool sided = mirrored ? joint.partner != static_cast<int16_t>(index)
                              : is_paired_class(joint.joint_class) || joint.joint_class == kClassWing;
  if (!sided) return kNoSide;
  if (joint.side != 0) return joint.side > 0 ? kLeft : kRight;
  return joint.position.x >= 0 ? kLeft : kRight;
}

SINEW_RARE char* append(char* to, const char* text) {
  while (*text != 0) *to++ = *text++;
  return to;
}

// Nothing for 0.
SINEW_RARE char* append(char* to, uint32_t number) {
  char digits[10];
  uint32_t count = 0;
  for (; number > 0; number /= 10) digits[count++] = static_cast<char>('0' + number % 10);
  while (count > 0) *to++ = digits[--count];
  return to;
}

}  // namespace

SINEW_RARE void name_joints(const RigJoint* joints, uint32_t count, char (*names)[kMaxJointName]) {
  uint16_t taken[3][kJointClasses] = {};
  uint8_t ends[kMaxRigJoints] = {};  // of each joint
  for (uint32_t i = 0; i < count; ++i) {
    char* to = names[i];
    if (joints[i].tip != 0) {
      to = append(append(to, names[joints[i].parent]), "_end");
      to = append(to, ends[joints[i].parent]++);
    } else {
      const Side side = side_of(joints[i], i);
      const uint32_t c = joints[i].joint_class;
      (void)names::standard_name(SINEW_NAMING_SINEW, c, side, taken[side + 1][c]++, to);
      continue;
    }
    *to = 0;
  }
}

}  // namespace sinew::rigging
