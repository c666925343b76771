// SPDX-License-Identifier: MIT
// Which joints a skeleton gives up first, and which last: by what names say they are, else by a human body laid over it.
#ifndef SINEW_SIMPLIFY_JOINT_RANKS_HPP
#define SINEW_SIMPLIFY_JOINT_RANKS_HPP

#include "core/arena.hpp"
#include "sinew/skeleton.h"

namespace sinew::simplifying {

// In the order in which joints go.
enum JointRank : uint8_t {
  kRankDetail = 0,  // bone ends, controls, slots, twists, helpers, faces
  kRankFinger = 1,
  kRankPart = 2,   // all else: toe, tail, wing, ear, hair
  kRankTrunk = 3,  // clavicle, neck, hip joint, the spine's middle, a root above the pelvis
  kRankBody = 4    // pelvis, first and last of the spine, head, upper and lower arms and legs, hands, feet
};

//   areas  [J] surface that moves with a joint, or null
//   ranks  out, [J] JointRank; is_end out, [J] 1 for a bone's end
// Parents are checked before. Null outputs where the arena measures.
sinew_status find_joint_ranks(const sinew_skeleton& skeleton, const float* areas, Arena& arena, uint8_t* ranks,
                              uint8_t* is_end);

}  // namespace sinew::simplifying
#endif
