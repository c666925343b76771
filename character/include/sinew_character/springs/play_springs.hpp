// SPDX-License-Identifier: MIT
// Simulates springs in a clip.
#ifndef SINEW_CHARACTER_PLAY_SPRINGS_HPP
#define SINEW_CHARACTER_PLAY_SPRINGS_HPP

#include "sinew_formats/motion.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {

struct SpringPlay {
  bool loops = false;  // the poses of its first and last frames are equal
  double gap = 0;      // of a loop: largest angle of a chain's joint between the end and the start, degrees
  size_t passes = 1;   // number of passes until it closed
  size_t joints = 0;   // number of joints that rotate
};

// Rotates the chains' joints in all frames of a clip, by sinew/springs.h. A clip whose first and last poses are equal
// is repeated until the state of its chains closes, at most eight times, with continued travel of the root. Other
// clips begin at rest in their first pose.
//   motion  motion of the joints of `springs`, clip of the motion
// Throws Error.
SpringPlay play_springs(const Springs& springs, const Motion& motion, Clip* clip);

}  // namespace sinew
#endif
