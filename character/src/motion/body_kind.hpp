// SPDX-License-Identifier: MIT
// The kind of body of a skeleton, as far as motions depend on it: number of legs, and whether it is upright.
#ifndef SINEW_CHARACTER_MOTION_BODY_KIND_HPP
#define SINEW_CHARACTER_MOTION_BODY_KIND_HPP

#include <optional>
#include <string>

#include "motion/body_parts.hpp"

namespace sinew {

struct BodyKind {
  std::optional<size_t> legs;   // empty: unknown
  std::optional<bool> upright;  // of bodies with legs and something above them
};

// From the names of its joints, and from the number of limbs on the floor at rest if the up axis is known.
BodyKind body_kind(const MapRig& rig, const BodyParts& parts);

// 0 where what is known of both agrees; else a gait of the one is none of the other, the less the larger.
size_t difference(const BodyKind& a, const BodyKind& b);

// "an upright body on 2 legs", "a body on 4 legs".
std::string text_of(const BodyKind& kind);

}  // namespace sinew
#endif
