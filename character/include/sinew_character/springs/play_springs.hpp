// SPDX-License-Identifier: MIT
// Springs played behind a clip, into it.
#ifndef SINEW_CHARACTER_PLAY_SPRINGS_HPP
#define SINEW_CHARACTER_PLAY_SPRINGS_HPP

#include "sinew_formats/motion.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {

struct SpringPlay {
  bool loops = false;  // its last frame's pose is its first one's
  double gap =
      0;  // of a loop: the largest angle between a chain's joint after the last frame and before the first, degrees
  size_t passes = 1;  // until it closed
  size_t joints = 0;  // that turn
};

// Turns the chains' joints in all frames of a clip, by sinew/springs.h. A clip whose last pose is its first one is played until its chains'
// state before the first frame is that after the last, eight times at most; where the root travels, it travels on. Another clip begins at rest in
// its first pose.
//   motion  of the joints that `springs` are of, clip of the motion
// Throws Error.
SpringPlay play_springs(const Springs& springs, const Motion& motion, Clip* clip);

}  // namespace sinew
#endif
