// SPDX-License-Identifier: MIT
// Names of the clips that ship.
#include "sinew_character/clips/builtin_motion.hpp"

#include <algorithm>
#include <iterator>

#include "clips/performance.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

using clips::Block;

const std::string kPrefix = "builtin:";

// Contents of gaits/, read once: a kind and its clips for each file, then the variants.
struct Gaits {
  std::vector<std::vector<Block>> kinds;
  std::vector<Block> variants;
};
const std::string& name_of(const Block& block) { return block.head.names.at(0); }

// A kind that is like another one has that one's lines before its own, and those of its clips that it names, or all.
void add_likeness(const std::vector<std::vector<Block>>& kinds, std::vector<Block>* kind) {
  if (kind->front().lines.empty() || kind->front().lines[0].verb != "like") return;
  const std::vector<std::string> names = kind->front().lines[0].names;
  for (const std::vector<Block>& other : kinds) {
    if (name_of(other[0]) != names.at(0)) continue;
    std::vector<clips::Line>& lines = kind->front().lines;
    lines.insert(lines.begin(), other[0].lines.begin(), other[0].lines.end());
    std::copy_if(other.begin() + 1, other.end(), std::back_inserter(*kind), [&](const Block& clip) {
      return names.size() == 1 || std::find(names.begin() + 1, names.end(), name_of(clip)) != names.end();
    });
  }
}

const Gaits& gaits() {
  static const Gaits all = [] {
    Gaits read;
    for (const TemplateText* one = clips::gait_texts(); one->name != nullptr; ++one) {
      std::vector<Block> blocks = clips::read_gaits(one->name + std::string(".txt"), one->text);
      if (blocks.at(0).head.verb == "variant") {
        read.variants = std::move(blocks);
        continue;
      }
      add_likeness(read.kinds, &blocks);
      read.kinds.push_back(std::move(blocks));
    }
    return read;
  }();
  return all;
}

[[noreturn]] void refuse(const std::string& path) {
  std::string names, variants;
  for (const std::vector<Block>& kind : gaits().kinds) {
    names += (names.empty() ? " " : "; ") + name_of(kind[0]) + ": ";
    for (size_t c = 1; c < kind.size(); ++c) names += (c == 1 ? "" : ", ") + name_of(kind[c]);
  }
  for (const Block& variant : gaits().variants) variants += (variants.empty() ? "" : ", ") + name_of(variant);
  const std::string found = path.substr(kPrefix.size());
  throw Error(path + ": expected " + kPrefix + "NAME, " + kPrefix + "KIND/NAME or " + kPrefix +
              "KIND, or one of them with :VARIANT (" + variants + "), with" + names + "; found " +
              (found.empty() ? "no name" : in_quotes(found)));
}

}  // namespace

bool is_builtin_motion(const std::string& path) { return path.rfind(kPrefix, 0) == 0; }

std::vector<Motion> builtin_motions(const std::string& path) {
  const std::string asked = path.substr(std::min(path.size(), kPrefix.size()));
  const size_t colon = asked.find(':');
  const std::string of = asked.substr(0, colon);
  const Block* variant = nullptr;
  for (const Block& one : gaits().variants)
    if (colon != std::string::npos && name_of(one) == asked.substr(colon + 1)) variant = &one;
  if (colon != std::string::npos && variant == nullptr) refuse(path);
  const size_t slash = of.find('/');
  const std::string name = slash == std::string::npos ? of : of.substr(slash + 1);
  std::vector<Motion> motions;
  for (const std::vector<Block>& kind : gaits().kinds) {
    const bool whole = of == name_of(kind[0]);
    if (slash != std::string::npos && of.substr(0, slash) != name_of(kind[0])) continue;
    clips::Puppet puppet = clips::puppet_of(kind[0]);
    Motion motion = puppet.motion();
    motion.name = name;
    motion.rest_stands = true;
    for (size_t c = 1; c < kind.size(); ++c)
      if (whole || name_of(kind[c]) == name) motion.clips.push_back(clips::perform(&puppet, kind[0], kind[c], variant));
    if (!motion.clips.empty()) motions.push_back(std::move(motion));
  }
  if (motions.empty()) refuse(path);
  return motions;
}

}  // namespace sinew
