// SPDX-License-Identifier: MIT
// Motions that the page's character plays: its file's own, or those of another skeleton.
#ifndef SINEW_WEB_PLAYER_HPP
#define SINEW_WEB_PLAYER_HPP

#include <nlohmann/json.hpp>
#include <string>

#include "sinew_formats/motion.hpp"

namespace sinew::web {

class Player {
 public:
  // Retargets every clip of the file to the character; a motion that is there already stays when that fails. Throws Error.
  //   up  0 = Y, 1 = Z, the character's
  //   own  the file is the character's own
  // Returns {clips: [{name, frames, seconds}], joints, mapped, how, notes: [one line each]}.
  nlohmann::ordered_json open(const std::string& file, const Character& character, uint32_t up, bool own);
  void close() { motion_ = Motion(); }

  // What a file of the character gets: null when nothing is open, or what its own file has already.
  const Motion* for_file() const { return motion_.clips.empty() || own_ ? nullptr : &motion_; }
  // Pose times inverse bind of all joints, `seconds` into a clip.
  std::vector<Affine> palette(uint32_t clip, double seconds) const;

 private:
  Motion motion_;  // of the character's joints
  bool own_ = false;
};

}  // namespace sinew::web
#endif
