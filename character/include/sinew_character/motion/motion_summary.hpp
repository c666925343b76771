// SPDX-License-Identifier: MIT
// What a motion's skeleton is, in words: for people who look before they retarget.
#ifndef SINEW_CHARACTER_MOTION_SUMMARY_HPP
#define SINEW_CHARACTER_MOTION_SUMMARY_HPP

#include <string>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct RestSummary {
  MaybeAxis up;      // of a body that stands at rest; none where nobody can tell
  std::string pose;  // "stands, arms out to the sides (T pose)"
};

// By the joints that stand for limbs, so it is a guess for skeletons of other bodies than people's. Throws Error.
RestSummary rest_summary(const Motion& motion);

}  // namespace sinew
#endif
