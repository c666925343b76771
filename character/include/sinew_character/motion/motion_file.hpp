// SPDX-License-Identifier: MIT
// Reads motions given by the user: a file, or a built-in clip.
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
  MaybeAxis down = {};      // axis that points down in the motion's world
  bool find_down = true;    // without `down`: detects a body that is upside down, with a note
};
struct MotionFile {
  Motion motion;
  bool whole = true;  // all joints of the file unchanged; false: one of its actors, possibly rotated upright
};
// Reads a motion by read_motion() and one_actor(), or selects the one of builtin_motions() whose body maps best onto
// the target.
MotionFile read_motion_for(const MotionRequest& request, const MapRig& target);

// Returns the axis that points down if a body is upside down at rest and in most frames; otherwise, and for a body
// without known legs, nullopt.
MaybeAxis axis_that_points_down(const Motion& motion);
// Rotates a motion so that this axis points up.
Motion turned_over(Motion motion, Axis down);
void turn_over(Axis down, std::vector<Joint>* joints);

// Returns the motion with its frames rotated upright: some captures have a rest pose with y up and frames with z up.
// Returns nullopt if rest pose and frames agree, if the rest pose is not a standing pose, or if the body lies on the
// floor of the rest pose, like a sleeping person. The result has a note, since it is a guess.
std::optional<Motion> motion_on_rest_floor(const Motion& motion);

}  // namespace sinew
#endif
