// SPDX-License-Identifier: MIT
// A motion's file to clips of the character, as sinew animate makes them.
#include "player.hpp"

#include <algorithm>

#include "sinew_datasets/motion_map.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/map_skeleton.hpp"
#include "sinew_formats/retarget.hpp"

namespace sinew::web {

nlohmann::ordered_json Player::open(const std::string& file, const Character& character, uint32_t up, bool own) {
  const Motion source = read_motion(file);
  MapRig target = map_rig_of(character), from = map_rig_of(source);
  target.name = character.name;
  from.name = file;
  const std::string axis = up == 1 ? "z" : "auto";
  const MotionMap map = map_motion(target, from, axis, "auto", "");
  RetargetSettings settings;
  settings.target_up = up == 1 ? SINEW_UP_Z : SINEW_UP_AUTO;
  Retargeter retargeter(source, character.joints, map.sources, motion_classes(target, from, axis, map.sources),
                        settings);
  const std::optional<Character> body = body_of_motion(file);
  (void)retargeter.take_bodies(character, body ? &*body : nullptr);
  retargeter.keep_contacts();
  retargeter.keep_range();
  Motion made = motion_of(character.joints);
  nlohmann::ordered_json reply;
  reply["clips"] = nlohmann::ordered_json::array();
  for (const Clip& clip : source.clips) {
    if (clip.frames.empty()) continue;
    made.clips.push_back(retargeter.run(clip));
    reply["clips"].push_back({{"name", clip.name},
                              {"frames", clip.frames.size()},
                              {"seconds", static_cast<double>(clip.frames.size() - 1) * clip.frame_time}});
  }
  if (made.clips.empty()) throw Error(file + ": expected a motion, found a skeleton without frames");
  reply["joints"] = character.joints.size();
  reply["mapped"] =
      character.joints.size() - static_cast<size_t>(std::count(map.sources.begin(), map.sources.end(), -1));
  reply["how"] = map.how;
  reply["notes"] = source.notes;
  if (map.certainty < kDoubtfulSides)
    reply["notes"].push_back("Which way is front is not sure: left and right may be exchanged");
  motion_ = std::move(made);
  own_ = own;
  return reply;
}

std::vector<Affine> Player::palette(uint32_t clip, double seconds) const {
  if (clip >= motion_.clips.size()) throw Error("no motion is open");
  return motion_palette(motion_, frame_at(motion_.clips[clip], seconds), motion_.joints.size());
}

}  // namespace sinew::web
