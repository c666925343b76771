// SPDX-License-Identifier: MIT
// Motions as users name them: a file, or a clip that ships.
#ifndef SINEW_CHARACTER_MOTION_FILE_HPP
#define SINEW_CHARACTER_MOTION_FILE_HPP

#include <optional>
#include <string>
#include <vector>

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
  MaybeAxis down = {};      // axis of the motion's world that points down
  bool find_down = true;    // without one: looks whether the body stands upside down; a note says so
};
struct MotionFile {
  Motion motion;
  bool whole = true;  // all joints of the file as they stand there; false: one of its actors, or turned over
};
// read_motion() and one_actor(), or of builtin_motions() the one whose body maps best onto the target.
MotionFile read_motion_for(const MotionRequest& request, const MapRig& target);

// The axis that points down where a body stands upside down at rest and in most frames; nullopt elsewhere, and where nobody knows its legs.
MaybeAxis axis_that_points_down(const Motion& motion);
// The same in a world of which that axis points up.
Motion turned_over(Motion motion, Axis down);
void turn_over(Axis down, std::vector<Joint>* joints);

// The same motion with its frames turned upright: some captures draw their skeleton with y up and go over a floor across z. nullopt where rest pose and
// frames agree on up, where the rest pose does not stand, and where the body lies on the rest pose's own floor, as somebody asleep does. A guess, which a
// note of the motion tells.
std::optional<Motion> motion_on_rest_floor(const Motion& motion);

}  // namespace sinew
#endif
