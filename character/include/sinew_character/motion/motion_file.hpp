// SPDX-License-Identifier: MIT
// Motions as users name them: a file, or a clip that ships.
#ifndef SINEW_CHARACTER_MOTION_FILE_HPP
#define SINEW_CHARACTER_MOTION_FILE_HPP

#include <string>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/axis.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct MotionRequest {
  std::string path;
  double fps = 0;           // as in read_motion()
  std::string layout = {};  // as in read_motion()
  std::string actor = {};   // as in one_actor()
  MaybeAxis up = {};        // of the target
};
struct MotionFile {
  Motion motion;
  bool whole = true;  // all joints of the file; false: one of its actors
};
// read_motion() and one_actor(), or of builtin_motions() the one whose body maps best onto the target.
MotionFile read_motion_for(const MotionRequest& request, const MapRig& target);

}  // namespace sinew
#endif
