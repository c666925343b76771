// SPDX-License-Identifier: MIT
// Names of the clips that ship.
#include "sinew_character/clips/builtin_motion.hpp"

#include <algorithm>

#include "clips/puppet.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

const std::string kPrefix = "builtin:";

// To add a clip: a function in the kind's source, its name there and here.
struct Kind {
  const char* name;
  Motion (*make)();
  std::vector<std::string> clips;
};
const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"person", clips::person_clips, {"walk", "run", "idle", "wave", "jump", "sit", "squat", "reach"}},
      {"quadruped", clips::quadruped_clips, {"walk", "trot", "idle"}},
      {"bird", clips::bird_clips, {"flap"}},
      {"fish", clips::fish_clips, {"swim"}},
      {"spider", clips::spider_clips, {"crawl"}}};
  return all;
}

bool has_clip(const Kind& kind, const std::string& name) {
  return std::find(kind.clips.begin(), kind.clips.end(), name) != kind.clips.end();
}

[[noreturn]] void refuse(const std::string& path) {
  std::string names;
  for (const Kind& kind : kinds()) {
    names += names.empty() ? " " : "; ";
    names += std::string(kind.name) + ": ";
    for (const std::string& clip : kind.clips) names += (clip == kind.clips[0] ? "" : ", ") + clip;
  }
  const std::string found = path.substr(kPrefix.size());
  throw Error(path + ": expected " + kPrefix + "NAME, " + kPrefix + "KIND/NAME or " + kPrefix + "KIND, with" + names +
              "; found " + (found.empty() ? "no name" : in_quotes(found)));
}

}  // namespace

bool is_builtin_motion(const std::string& path) { return path.rfind(kPrefix, 0) == 0; }

std::vector<Motion> builtin_motions(const std::string& path) {
  const std::string asked = path.substr(std::min(path.size(), kPrefix.size()));
  const size_t slash = asked.find('/');
  const std::string name = slash == std::string::npos ? asked : asked.substr(slash + 1);
  std::vector<Motion> motions;
  for (const Kind& kind : kinds()) {
    const bool whole = asked == kind.name;
    const bool other = slash != std::string::npos && asked.substr(0, slash) != kind.name;
    if (!whole && (other || !has_clip(kind, name))) continue;
    Motion motion = kind.make();
    motion.name = name;
    if (!whole) motion.clips = {Clip(find_clip(motion, path, name))};
    motions.push_back(std::move(motion));
  }
  if (motions.empty()) refuse(path);
  return motions;
}

}  // namespace sinew
