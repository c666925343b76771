// SPDX-License-Identifier: MIT
// Maps of joints as text that can be edited and given back.
#include <map>
#include <optional>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

// Joints by name, as it is and as it is written.
class JointIndex {
 public:
  explicit JointIndex(const MapRig& rig) : rig_(rig), index_(joints_by_name(rig.joints)) {}
  std::optional<uint32_t> find(const std::string& name) const {
    const auto found = index_.find(name);
    if (found == index_.end()) return std::nullopt;
    return found->second;
  }
  uint32_t get(const std::string& where, const std::string& name) const {
    const std::optional<uint32_t> found = find(name);
    if (!found)
      throw Error(where + ": expected a joint of " + rig_.name + " (its first is " + rig_.joints[0].name + "), found " +
                  in_quotes(name));
    return *found;
  }

 private:
  const MapRig& rig_;
  std::map<std::string, uint32_t> index_;
};

}  // namespace

const char* map_reason_text(uint8_t reason) {
  switch (reason) {
    case SINEW_MAP_PINNED:
      return "as asked";
    case SINEW_MAP_NO_COUNTERPART:
      return "the source has no match";
    case SINEW_MAP_FEWER_JOINTS:
      return "the source has fewer joints there";
    case SINEW_MAP_END:
      return "end of a bone";
    case SINEW_MAP_OUTSIDE:
      return "beside the body";
    case SINEW_MAP_TAKEN:
      return "its source matched another joint, or the pairs would cross";
    case SINEW_MAP_BESIDE_LIMITS:
      return "too many limbs; only the first ones are mapped";
    default:
      return "";
  }
}

std::string map_text(const MapRig& target, const MapRig& source, const MappedSkeleton& map) {
  const std::vector<std::string> targets = names_without_blanks(target.joints),
                                 sources = names_without_blanks(source.joints);
  std::string text;
  for (size_t j = 0; j < targets.size(); ++j)
    text += targets[j] + " " + (map.sources[j] < 0 ? "-" : sources[static_cast<size_t>(map.sources[j])]) + "\n";
  return text;
}

std::vector<sinew_map_pin> read_map_file(const std::string& path, const MapRig& target, const MapRig& source,
                                         MapRepeats repeats) {
  const std::string text = read_text_file(path);
  const JointIndex targets(target), sources(source);
  std::vector<sinew_map_pin> pins;
  std::map<uint32_t, size_t> target_lines, source_lines;
  TextLines lines(path, text);
  const auto once = [&](std::map<uint32_t, size_t>* seen, uint32_t joint, std::string_view word) {
    const auto [at, is_new] = seen->emplace(joint, lines.number());
    if (!is_new) lines.fail("each joint once (the first is line " + std::to_string(at->second) + ")", word);
  };
  while (lines.next()) {
    const auto& words = lines.words();
    if (words.empty() || words[0][0] == '#') continue;
    if (words.size() < 2 || (words.size() > 2 && words[2][0] != '#'))
      lines.fail("'TARGET_JOINT SOURCE_JOINT' or 'TARGET_JOINT -'", lines.line());
    const std::string where = path + ":" + std::to_string(lines.number());
    sinew_map_pin pin = {targets.get(where, std::string(words[0])), -1};
    if (repeats != MapRepeats::kTargets) once(&target_lines, pin.target, words[0]);
    if (words[1] != "-") {
      const uint32_t joint = sources.get(where, std::string(words[1]));
      if (repeats != MapRepeats::kSources) once(&source_lines, joint, words[1]);
      pin.source = static_cast<int32_t>(joint);
    }
    pins.push_back(pin);
  }
  return pins;
}

sinew_map_pin parse_map_pin(const std::string& text, const MapRig& target, const MapRig& source) {
  const JointIndex targets(target), sources(source);
  // Names may hold a '=': the first cut at which both sides are joints counts.
  size_t first = std::string::npos;
  for (size_t cut = text.find('='); cut != std::string::npos; cut = text.find('=', cut + 1)) {
    if (first == std::string::npos) first = cut;
    const std::optional<uint32_t> joint = targets.find(text.substr(0, cut));
    const std::string name = text.substr(cut + 1);
    const std::optional<uint32_t> other = sources.find(name);
    if (joint && other) return {*joint, static_cast<int32_t>(*other)};
    if (joint && name == "-") return {*joint, -1};
  }
  if (first == std::string::npos || first == 0 || first + 1 == text.size())
    throw Error("expected TARGET_JOINT=SOURCE_JOINT or TARGET_JOINT=-, found " + in_quotes(text));
  (void)targets.get(in_quotes(text), text.substr(0, first));
  (void)sources.get(in_quotes(text), text.substr(first + 1));
  throw Error("expected TARGET_JOINT=SOURCE_JOINT, found " +
              in_quotes(text));  // not reached: one of the two is unknown
}

}  // namespace sinew
