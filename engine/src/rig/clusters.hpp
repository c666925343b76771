// SPDX-License-Identifier: MIT
// Votes to folded joints: where votes of a class gather, what is a duplicate, and what no joint explains.
#ifndef SINEW_RIG_CLUSTERS_HPP
#define SINEW_RIG_CLUSTERS_HPP

#include "rig/rig_joint.hpp"
#include "sinew/sinew.h"
#include "votes/mean_shift.hpp"
#include "votes/votes.hpp"

namespace sinew::rigging {

constexpr int32_t kVoteWidth = side_share(280);  // of the kernel: how far votes for one joint lie apart

// All votes in the order of a cloud.
struct VotePool {
  const Votes* votes = nullptr;
  bool mirrored = false;       // votes lie at |x|
  uint32_t count = 0;          // 2 N
  Vec3i* at = nullptr;         // [2 N]
  uint16_t* trust = nullptr;   // [2 N] Q15: 1 / (1 + spread / 0.05)^2
  uint16_t* source = nullptr;  // [2 N] twice the point, and 1 for its bone's end
  uint16_t* order = nullptr;   // [2 N] scratch

  // Takes memory; fills it where the arena does not measure. False if the arena is full.
  bool build(const Votes& v, bool mirror, Arena& arena);
  // Q15. Starts are never tips.
  uint32_t probability(uint32_t vote, uint32_t joint_class) const {
    const size_t point = source[vote] >> 1;
    if ((source[vote] & 1) != 0) return votes->end_class[point * kEndClasses + joint_class];
    return joint_class < kJointClasses ? votes->start_class[point * kJointClasses + joint_class] : 0;
  }
};

// Where a vote counts, and Q15 how far to trust one of that spread.
inline Vec3i folded_position(Vec3i p, bool mirrored) { return {mirrored && p.x < 0 ? -p.x : p.x, p.y, p.z}; }
uint32_t trust_in(uint32_t spread);

// A joint with x > 0 of mirrored votes represents two.
struct FoldedJoint {
  Vec3i at = {0, 0, 0};
  uint8_t joint_class = kClassPelvis;
  int64_t mass = 0;  // Q15: weight of its votes
};

// The joints that votes are for, by falling mass; those of votes that none of the classes explains come last.
//   joints  out  [kMaxFoldedJoints]
//   arena        scratch, all of it released
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE. A function of the votes as a set: their order does not matter.
sinew_status find_folded_joints(const VotePool& pool, Arena& arena, FoldedJoint* joints, uint32_t* count);

}  // namespace sinew::rigging
#endif
