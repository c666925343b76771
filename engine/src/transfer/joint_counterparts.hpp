// SPDX-License-Identifier: MIT
// Which joint of the target represents which of the source, completed where one of the two has joints that the other lacks.
#ifndef SINEW_TRANSFER_JOINT_COUNTERPARTS_HPP
#define SINEW_TRANSFER_JOINT_COUNTERPARTS_HPP

#include "skeleton/skeleton.hpp"

namespace sinew::transferring {

struct JointCounterparts {
  int32_t* same = nullptr;       // [source joints] its counterpart in the target, or -1
  int32_t* target_of = nullptr;  // [source joints] the target's joint that takes its weight, or -1
  // [target joints] its nearest ancestor (itself included) that takes weight: a joint that the source lacks shares what
  // its head gets. Itself where there is none.
  int32_t* head = nullptr;
  uint8_t* is_new = nullptr;  // [target joints] 1: no joint of the source gives it weight

  bool allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints);
  // From the caller's counterparts [source joints], checked. A joint whose counterpart is missing or must get no weight gives
  // its weight to its nearest mapped ancestor's counterpart, else to its nearest mapped descendant's.
  //   scratch  [source joints x 2]
  void complete(const int32_t* counterparts, const Skeleton& source, const Skeleton& target, uint32_t* scratch);
};

}  // namespace sinew::transferring
#endif
