// SPDX-License-Identifier: MIT
// Motions that the page's character plays: its file's own, or those of another skeleton, by any method of sinew animate.
#ifndef SINEW_WEB_PLAYER_HPP
#define SINEW_WEB_PLAYER_HPP

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/picture/picture_job.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::web {

enum class MotionMethod : uint32_t { kContacts = 0, kCopy, kReferencePoints, kStream };

class Player {
 public:
  // Retargets every clip of the files, one after another, to the character; motions that are there already stay when that fails. Throws Error.
  //   files  of the module, or builtin:NAME
  //   picture  that the character is of, which moves in its plane; null: of none
  //   up     the character's: 0 = Y, 1 = Z, 2 = found
  //   own    the one file is the character's own
  //   pins   [files] of their maps, which the rest follows
  // Returns {clips: [{name, file, frames, seconds, room, limbs}], joints, files: [{file, mapped, how, sourceJoints: [{name, parent}], map: [{source,
  // why}], notes: [one line each]}]}.
  nlohmann::ordered_json open(const std::vector<std::string>& files, const Character& character,
                              std::shared_ptr<const PictureCharacter> picture, uint32_t up, bool own,
                              MotionMethod method, const std::vector<std::vector<sinew_map_pin>>& pins);
  // The same motion by another method; made when it is first asked for. Returns {clips}.
  nlohmann::ordered_json use(MotionMethod method);
  void close() { open_.reset(); }

  // What a file of the character gets: null when nothing is open, or what its own file has already.
  const Motion* for_file() const { return open_ && !open_->own ? &open_->now->motion : nullptr; }
  // Pose times inverse bind of all joints, `seconds` into a clip.
  std::vector<Affine> palette(uint32_t clip, double seconds) const;
  // [{joint, kind, place, error}]: what limbs do in the frame that is nearest, see sinew_contact_spot.
  nlohmann::ordered_json spots(uint32_t clip, double seconds) const;

 private:
  // By one method.
  struct Made {
    Motion motion;  // of the character's joints
    std::vector<AnimatedClip> clips;
    std::vector<size_t> files;                    // [clips]
    std::vector<MotionMap> maps;                  // [files]
    std::vector<std::vector<std::string>> notes;  // [files]
  };
  struct Source {
    std::string file;
    Motion motion;
    std::optional<Character> body;
    std::vector<sinew_map_pin> pins;
  };
  struct Opened {
    std::vector<Source> sources;
    AnimatedCharacter work;  // the character, and the method that is being made
    std::shared_ptr<const PictureCharacter> picture;
    uint32_t up = 0;
    bool own = false;
    std::map<MotionMethod, Made> made;
    const Made* now = nullptr;
  };
  static Source read(const std::string& file, const Character& character, uint32_t up);
  static void make(MotionMethod method, Opened* opened);
  static nlohmann::ordered_json clips_json(const Opened& opened);
  const Opened& opened(uint32_t clip) const;

  std::unique_ptr<Opened> open_;
};

}  // namespace sinew::web
#endif
