// SPDX-License-Identifier: MIT
// The job of `sinew simplify` for one character: removes joints; weights and animations follow.
#ifndef SINEW_CHARACTER_SIMPLIFY_JOB_HPP
#define SINEW_CHARACTER_SIMPLIFY_JOB_HPP

#include <vector>

#include "sinew_character/motion/simplify_skeleton.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct SimplifiedCharacter {
  Simplified simplified;
  Motion motion;  // clips of all `motions`, for the remaining joints
};

//   motions  motions of the character's joints before simplification
// At the high level a joint is kept if vertices would move by more than 1 % of the character's height without it, in
// poses of the motions; without weights the joints' positions count. Throws Error and then leaves the character
// unchanged.
SimplifiedCharacter simplify_character(const SimplifyOptions& options, const std::vector<const Motion*>& motions,
                                       Character* character);

}  // namespace sinew
#endif
