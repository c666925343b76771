// SPDX-License-Identifier: MIT
// The motion of a handle, as sinew_character_animate() plays it and sinew_character_map() maps from it.
#ifndef SINEW_CHARACTER_CAPI_MOTION_OF_HPP
#define SINEW_CHARACTER_CAPI_MOTION_OF_HPP

#include <utility>

#include "handle.hpp"
#include "sinew_character/motion/map_source.hpp"
#include "sinew_character/motion/motion_file.hpp"

namespace sinew {

inline bool plays_its_file(const sinew_character& from) {
  return from.clips.empty() && !from.path.empty() && !from.drop_animations;
}

// The clips that were added to a character.
inline MotionFile added_motion(const sinew_character& from) {
  Motion added = motion_of(from.character.joints);
  added.name = from.character.name;
  added.clips = from.clips;
  return {std::move(added), true};
}

// The mesh that moves with it; null: none, or one of several people.
inline const Character* body_of(const sinew_character& from, const MotionFile& motion) {
  return from.character.vertices.empty() || !motion.whole ? nullptr : &from.character;
}

}  // namespace sinew
#endif
