// SPDX-License-Identifier: MIT
// Votes of a hand's points to fingers: as many as there are votes that agree.
#ifndef SINEW_DETAILS_FINGERS_HPP
#define SINEW_DETAILS_FINGERS_HPP

#include "details/hand_class.hpp"
#include "rig/clusters.hpp"

namespace sinew::rigging {

struct Finger {
  uint8_t joints = 0;  // 0: there is none; at least kFewestFingerJoints otherwise
  bool has_end = false;
  Vec3i at[kFingerJoints + 1] = {};             // from the palm outward, then the end
  uint16_t confidence[kFingerJoints + 1] = {};  // Q15
};
constexpr uint32_t kFewestFingerJoints = 2;
constexpr uint32_t kFewestFingers = 3;  // of a hand that has any

// Each class of joints has its votes, and the joint is where most of them gather, if enough of them gather at all. A
// finger is what joints of it there are, its end where most tips of its last joint are. Of two fingers at one position the
// one with more votes stays, and likewise of two ends. A hand with fewer than kFewestFingers has none.
//   pool     not mirrored, of the hand's own grid (hand_crop.hpp)
//   fingers  out
//   arena    scratch, all of it released
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE. A function of the votes as a set.
sinew_status find_fingers(const VotePool& pool, Arena& arena, Finger (&fingers)[kFingers]);

}  // namespace sinew::rigging
#endif
