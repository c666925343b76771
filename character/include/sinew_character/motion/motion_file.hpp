// SPDX-License-Identifier: MIT
// Motions as users name them: a file, or a clip that ships.
#ifndef SINEW_CHARACTER_MOTION_FILE_HPP
#define SINEW_CHARACTER_MOTION_FILE_HPP

#include <optional>
#include <string>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/box.hpp"
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

// The same motion with its frames turned upright: some captures draw their skeleton with y up and go over a floor across z. nullopt where rest pose and
// frames agree on up, where the rest pose does not stand, and where the body lies on the rest pose's own floor, as somebody asleep does. A guess, which a
// note of the motion tells.
std::optional<Motion> motion_on_rest_floor(const Motion& motion);

}  // namespace sinew
#endif
