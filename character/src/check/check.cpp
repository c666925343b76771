// SPDX-License-Identifier: MIT
// Every rule over one character; the line that jobs end with; two versions against each other.
#include "sinew_character/check/check.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "check/findings.hpp"

namespace sinew {
namespace {

using Key = std::tuple<std::string, std::string, std::string, std::string, std::string>;

std::string joint_name(const std::vector<Joint>& joints, int joint) {
  return joint < 0 ? std::string() : joints[static_cast<size_t>(joint)].name;
}

Key key_of(const RigFinding& f, const std::vector<Joint>& joints) {
  return {f.rule->name, joint_name(joints, f.joint), joint_name(joints, f.other), f.pose, f.clip};
}

std::vector<size_t> missing_in(const std::vector<RigFinding>& these, const std::vector<Joint>& joints,
                               const std::vector<RigFinding>& those, const std::vector<Joint>& their_joints) {
  std::map<Key, size_t> known;
  for (const RigFinding& f : those) ++known[key_of(f, their_joints)];
  std::vector<size_t> out;
  for (size_t i = 0; i < these.size(); ++i) {
    const auto found = known.find(key_of(these[i], joints));
    if (found == known.end() || found->second == 0)
      out.push_back(i);
    else
      --found->second;
  }
  return out;
}

}  // namespace

RigCheck check_rig(const Character& character, const Motion* motion, const CheckOptions& options) {
  for (const auto& [rule, bound] : options.bounds) check_rule(rule);
  const RigFacts facts(character);
  Findings findings(character, options);
  if (facts.bound) {
    check_rows(facts, &findings);
    check_stray_weights(facts, &findings);
  }
  check_joints(facts, &findings);
  check_names(facts, &findings);
  check_symmetry(facts, &findings);
  check_matrices(facts, &findings);
  check_spring_chains(facts, &findings);
  if (facts.bound && options.poses) check_poses(facts, &findings);
  if (motion != nullptr) check_clips(facts, *motion, &findings);
  weigh_findings(facts, &findings);
  return findings.take();
}

std::string checked_line(const RigCheck& check) {
  std::string line =
      "checked: " + std::to_string(check.findings.size()) + (check.findings.size() == 1 ? " finding" : " findings");
  std::vector<std::pair<std::string, size_t>> rules;
  for (const RigFinding& f : check.findings) {
    if (rules.empty() || rules.back().first != f.rule->name) rules.emplace_back(f.rule->name, 0);
    ++rules.back().second;
  }
  for (size_t r = 0; r < rules.size(); ++r)
    line += (r == 0 ? " (" : ", ") + std::to_string(rules[r].second) + " " + rules[r].first;
  return line + (rules.empty() ? "" : "); sinew check lists them");
}

std::string checked_note(const Character& character, const Motion* motion) {
  if (character.joints.empty() || character.influences.empty()) return "";
  CheckOptions cheap;
  cheap.poses = false;
  return checked_line(check_rig(character, motion, cheap));
}

void add_checked_note(Character* character) {
  std::string note = checked_note(*character);
  if (!note.empty()) character->notes.push_back(std::move(note));
}

CheckChange check_change(const RigCheck& before, const std::vector<Joint>& joints_before, const RigCheck& now,
                         const std::vector<Joint>& joints_now) {
  return {missing_in(now.findings, joints_now, before.findings, joints_before),
          missing_in(before.findings, joints_before, now.findings, joints_now)};
}

}  // namespace sinew
