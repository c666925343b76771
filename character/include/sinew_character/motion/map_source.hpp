// SPDX-License-Identifier: MIT
// What a file's motion is to a map: one reading of its stance, its ends and its joints that move, for `map`, `animate` and choices among clips.
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
  std::optional<Motion> standing;  // the motion against a stance that was guessed; empty: its rest pose is one
  MapRig rig;                      // in that stance
};

// The rest pose stays where the motion was made on the target, where its body has weights (that is how it was bound), and where it is a
// stance; see standing_motion(). Ends are those of map_rig_of(); with weights, leaves without any.
//   body    of the motion's own file, whose joints are the motion's first; null: none
//   target  joints of the skeleton that is to move
//   up      of the motion's world
MapSource map_source_of(const Motion& motion, const Character* body, const std::vector<Joint>& target, MaybeAxis up);

struct MapSourceRequest {
  std::string path;                     // as read_map_rig() takes it
  std::string layout = {}, actor = {};  // as in MotionRequest
  MaybeAxis up = {}, target_up = {};    // of either world
  MaybeAxis down = {};                  // as in MotionRequest
  bool find_down = true;
};
// A file's motion; nullopt for a skeleton alone. Throws Error for what is a motion alone and cannot be read, and for a layout or an actor
// that the file does not have.
std::optional<MotionFile> read_motion_in(const MapSourceRequest& request, const MapRig& target);
// The rig that `animate` would play the file's motion from; as read_map_rig() has it where the file has none. Throws Error.
MapRig read_map_source(const MapSourceRequest& request, const MapRig& target);

}  // namespace sinew
#endif
