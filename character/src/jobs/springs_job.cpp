// SPDX-License-Identifier: MIT
// Chains chosen and changed by name, with the body's colliders.
#include "sinew_character/jobs/springs_job.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "sinew_character/springs/fit_colliders.hpp"
#include "sinew_character/springs/make_chains.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

struct Field {
  const char* name;
  double low, high;
  double SpringJoint::*member;
};
constexpr double kLargest = 1e6;
constexpr size_t kInfluences = 4;  // of a vertex that follows laid chains, the most that every player reads
constexpr std::array<Field, 5> kFields = {{{"stiffness", 0, kLargest, &SpringJoint::stiffness},
                                           {"gravity", -kLargest, kLargest, &SpringJoint::gravity_power},
                                           {"drag", 0, 1, &SpringJoint::drag},
                                           {"radius", 0, kLargest, &SpringJoint::hit_radius},
                                           {"limit", 0, 180, &SpringJoint::limit}}};

bool fits(const std::string& name, const std::string& pattern) {
  if (pattern.empty() || pattern.back() != '*') return name == pattern;
  return name.compare(0, pattern.size() - 1, pattern, 0, pattern.size() - 1) == 0;
}

std::string names_of(const std::vector<FoundChain>& chains) {
  constexpr size_t kMost = 12;
  std::string out;
  for (size_t i = 0; i < chains.size() && i < kMost; ++i) out += (i == 0 ? "" : ", ") + chains[i].chain.name;
  return chains.empty() ? "none" : out + (chains.size() > kMost ? ", ..." : "");
}

template <class Change>
void change_named(const std::string& path, const std::string& pattern, std::vector<FoundChain>* chains, Change change) {
  size_t changed = 0;
  for (FoundChain& found : *chains) {
    if (!fits(found.chain.name, pattern)) continue;
    change(&found);
    ++changed;
  }
  if (changed == 0)
    throw Error(path + ": expected one of its chains, " + names_of(*chains) + ", found " + in_quotes(pattern));
}

// Chains of the file, without their colliders. A joint of two chains belongs to the first one.
std::vector<FoundChain> own_chains(const Springs& own, const Character& character) {
  std::vector<FoundChain> out;
  std::map<size_t, std::string> turned_by;
  for (const SpringChain& chain : own.chains) {
    FoundChain found;
    found.chain = chain;
    found.kind = kind_of_chain(chain, character);
    found.length = chain_length(chain, character.joints);
    found.reason = "the file's own";
    found.own = true;
    for (size_t i = 0; i < chain.turning_joints() && found.kept; ++i)
      if (const auto other = turned_by.find(chain.joints[i].joint); other != turned_by.end()) {
        found.kept = false;
        found.reason += ", left out since chain " + in_quotes(other->second) + " turns " +
                        in_quotes(character.joints[chain.joints[i].joint].name) + " already";
      }
    for (size_t i = 0; i < chain.turning_joints() && found.kept; ++i) turned_by[chain.joints[i].joint] = chain.name;
    out.push_back(std::move(found));
  }
  return out;
}

void set_preset(const std::string& path, const std::string& text, const Character& character,
                std::vector<FoundChain>* chains) {
  const size_t equals = text.rfind('=');
  const std::string word = equals == std::string::npos ? "" : text.substr(equals + 1);
  const std::optional<SpringKind> kind = spring_kind_of(word);
  if (!kind) throw Error("preset " + in_quotes(text) + ": expected CHAIN=KIND with one of " + spring_kinds_text());
  change_named(path, text.substr(0, equals), chains, [&](FoundChain* found) {
    found->kind = *kind;
    preset_chain(*kind, character, &found->chain);
  });
}

void set_value(const std::string& path, const std::string& text, std::vector<FoundChain>* chains) {
  const size_t equals = text.rfind('='), colon = text.rfind(':', equals);
  const std::string word =
      colon == std::string::npos || equals == std::string::npos ? "" : text.substr(colon + 1, equals - colon - 1);
  const auto field = std::find_if(kFields.begin(), kFields.end(), [&](const Field& one) { return word == one.name; });
  if (field == kFields.end())
    throw Error("value " + in_quotes(text) + ": expected CHAIN:FIELD=NUMBER or CHAIN:FIELD=xFACTOR with one of " +
                spring_fields_text());
  const std::string number = text.substr(equals + 1);
  const bool scales = number.compare(0, 1, "x") == 0;
  const double low = scales ? 0 : field->low, high = scales ? kLargest : field->high;
  const std::optional<double> value = to_finite_double(scales ? number.substr(1) : number);
  if (!value || !(*value >= low && *value <= high))
    throw Error("value " + in_quotes(text) + ": expected a number from " + std::to_string(static_cast<long>(low)) +
                " to " + std::to_string(static_cast<long>(high)) + (scales ? " after x" : "") + ", found " +
                in_quotes(number));
  change_named(path, text.substr(0, colon), chains, [&](FoundChain* found) {
    for (SpringJoint& joint : found->chain.joints) {
      double& changed = joint.*(field->member);
      changed = std::clamp(scales ? *value * changed : *value, field->low, field->high);
    }
  });
}

}  // namespace

std::string spring_fields_text() {
  std::string out;
  for (const Field& one : kFields) out += (out.empty() ? "" : ", ") + std::string(one.name);
  return out;
}

SpringsFound springs_of(const SpringsOptions& options, const std::string& path, const Character& character) {
  SpringsFound out;
  std::optional<Springs> own;
  if (!options.replace) own = read_springs(path, character);
  std::set<size_t> taken;
  if (own) {
    out.notes = own->notes;
    out.chains = own_chains(*own, character);
    for (const SpringChain& chain : own->chains)
      for (const SpringJoint& joint : chain.joints) taken.insert(joint.joint);
  }
  for (FoundChain& found : find_springs(character)) {
    const std::vector<SpringJoint>& joints = found.chain.joints;
    if (std::any_of(joints.begin(), joints.end(),
                    [&](const SpringJoint& joint) { return taken.count(joint.joint) != 0; }))
      continue;
    if (own) found.kept = false;
    out.chains.push_back(std::move(found));
  }
  for (const std::string& name : options.keep)
    change_named(path, name, &out.chains, [](FoundChain* found) { found->kept = true; });
  for (const std::string& name : options.drop)
    change_named(path, name, &out.chains, [](FoundChain* found) { found->kept = false; });
  for (const std::string& text : options.presets) set_preset(path, text, character, &out.chains);
  if (own) {
    out.springs.colliders = own->colliders;
    out.springs.groups = own->groups;
    out.errors.assign(own->colliders.size(), -1);
  }
  if (std::any_of(out.chains.begin(), out.chains.end(),
                  [](const FoundChain& found) { return found.kept && !found.own; }))
    assign_colliders(character, fit_colliders(character, out.chains), &out.chains, &out.springs, &out.errors);
  for (const std::string& text : options.values) set_value(path, text, &out.chains);
  for (const FoundChain& found : out.chains)
    if (found.kept) out.springs.chains.push_back(found.chain);
  return out;
}

bool make_spring_chains(SpringsOptions* options, Character* character) {
  const std::vector<MadeChains> made = make_chains(kInfluences, character);
  size_t first = character->joints.size();
  for (const MadeChains& one : made) first -= one.joints;
  for (const MadeChains& one : made) {
    character->notes.push_back(made_chains_text(one, character->joints));
    for (size_t chain = 0; chain < one.chains; ++chain, first += one.joints / one.chains)
      options->keep.push_back(character->joints[first].name);
  }
  if (made.empty()) character->notes.push_back("no skirt, coat or cape without joints of its own was found");
  return !made.empty();
}

void swing_clips(const SpringsOptions& options, const std::string& path, bool measure, AnimatedCharacter* out) {
  const SpringsFound found = springs_of(options, path, out->character);
  if (found.springs.chains.empty())
    throw Error(path + ": no chain swings; list candidates with sinew springs, keep one with --take");
  std::map<std::string, size_t> kinds;
  for (const FoundChain& one : found.chains)
    if (one.kept) ++kinds[spring_kind_text(one.kind)];
  std::string text;
  for (const auto& [kind, count] : kinds)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + kind + (count == 1 ? " chain" : " chains");
  out->motion.notes.push_back(path + ": simulated " + text + " with " + std::to_string(found.springs.colliders.size()) +
                              " colliders");
  swing_clips(found.springs, measure, out);
}

void swing_clips(const Springs& springs, bool measure, AnimatedCharacter* out) {
  if (out->motion.name.empty()) out->motion.name = out->character.name;  // for messages
  for (size_t c = 0; c < out->motion.clips.size(); ++c) {
    Clip& clip = out->motion.clips[c];
    const Clip rigid = measure ? clip : Clip();
    out->animated_clips[c].springs = play_springs(springs, out->motion, &clip);
    if (!measure) continue;
    const std::vector<uint8_t> swings = swinging_vertices(out->character, springs);
    const auto inside = [&](const Clip& of) { return inside_share(out->character, swings, out->motion, of); };
    out->animated_clips[c].swing = {static_cast<size_t>(std::count(swings.begin(), swings.end(), 1)), inside(rigid),
                                    inside(clip)};
  }
}

}  // namespace sinew
