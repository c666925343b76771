// SPDX-License-Identifier: MIT
// Describes a motion's skeleton in words, for `sinew inspect`.
#ifndef SINEW_CHARACTER_MOTION_SUMMARY_HPP
#define SINEW_CHARACTER_MOTION_SUMMARY_HPP

#include <string>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct RestSummary {
  MaybeAxis up;      // of a body that stands at rest; none if unknown
  std::string pose;  // "stands, arms out to the sides (T pose)"
};

// Uses the joints of limbs, so it is a guess for bodies other than people. Throws Error.
RestSummary rest_summary(const Motion& motion);

}  // namespace sinew
#endif
