// SPDX-License-Identifier: MIT
// A file's motion as the source of a map: rest pose, ends and moving joints, for `map`, `animate` and the choice of
// clips.
#ifndef SINEW_CHARACTER_MAP_SOURCE_HPP
#define SINEW_CHARACTER_MAP_SOURCE_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/motion_file.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct MapSource {
  std::optional<Motion> standing;  // the motion relative to a guessed standing pose; empty: its rest pose is one
  MapRig rig;                      // in that pose
};

// Keeps the rest pose if the motion was made on the target, if its body has weights (the bind pose), or if it is a
// standing pose; see standing_motion(). Ends are those of map_rig_of(); with weights, leaves without weight.
//   body    mesh in the motion's file, whose joints are the motion's first ones; null: none
//   target  joints of the skeleton to animate
//   up      up axis of the motion's world
MapSource map_source_of(const Motion& motion, const Character* body, const std::vector<Joint>& target, MaybeAxis up);

struct MapSourceRequest {
  std::string path;                     // as read_map_rig() takes it
  std::string layout = {}, actor = {};  // as in MotionRequest
  MaybeAxis up = {}, target_up = {};    // up axes of both worlds
  MaybeAxis down = {};                  // as in MotionRequest
  bool find_down = true;
};
// Reads a file's motion; nullopt for a skeleton only. Throws Error for a motion file that cannot be read, and for a
// layout or an actor that the file does not have.
std::optional<MotionFile> read_motion_in(const MapSourceRequest& request, const MapRig& target);
// Returns the source rig of `animate` for the file's motion, or that of read_map_rig() for a file without motion.
// Throws Error.
MapRig read_map_source(const MapSourceRequest& request, const MapRig& target);

}  // namespace sinew
#endif
