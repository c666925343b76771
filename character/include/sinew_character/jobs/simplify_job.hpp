// SPDX-License-Identifier: MIT
// What `sinew simplify` does with one character: joints are left out, weights and animations follow.
#ifndef SINEW_CHARACTER_SIMPLIFY_JOB_HPP
#define SINEW_CHARACTER_SIMPLIFY_JOB_HPP

#include <vector>

#include "sinew_character/motion/simplify_skeleton.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct SimplifiedCharacter {
  Simplified simplified;
  Motion motion;  // of the joints that are left: the clips of all `motions`
};

//   motions  of the character's joints, as they were, first
// At the high level a joint stays where vertices would move by more than 1 % of the character's height without it, in
// poses of the motions; without weights the joints' own positions count. Throws Error; the character is as it was then.
SimplifiedCharacter simplify_character(const SimplifyOptions& options, const std::vector<const Motion*>& motions,
                                       Character* character);

}  // namespace sinew
#endif
