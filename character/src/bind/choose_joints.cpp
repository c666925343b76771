// SPDX-License-Identifier: MIT
// Which joints of a character may get weight: by the weights it has, by names and positions, or all.
#include <algorithm>
#include <map>

#include "sinew_character/bind/bind_character.hpp"

namespace sinew {
namespace {

constexpr double kSomeWeight = 1e-3;  // in sum over a mesh; less is what exporters leave behind

size_t mesh_count(const Character& character) { return std::max<size_t>(1, character.meshes.size()); }
size_t mesh_of(const Character& character, size_t vertex) {
  return character.vertex_meshes.empty() ? 0 : character.vertex_meshes[vertex];
}

bool has_weights(const Character& character) {
  if (character.meshes.empty()) {
    return std::any_of(character.influences.begin(), character.influences.end(),
                       [](const std::vector<Influence>& row) { return !row.empty(); });
  }
  for (size_t v = 0; v < character.influences.size(); ++v)
    if (character.meshes[mesh_of(character, v)].skinned && !character.influences[v].empty()) return true;
  return false;
}

bool names_those_that_deform(const std::vector<uint8_t>& joint_flags) {
  return std::any_of(joint_flags.begin(), joint_flags.end(),
                     [](uint8_t flag) { return (flag & SINEW_JOINT_DEFORMS) != 0; });
}

void leave_out(const std::string& why, size_t joint, JointChoice* choice) {
  choice->flags[joint] |= SINEW_JOINT_NEVER;
  choice->left_out.push_back({joint, why});
}

void choose_own(const Character& character, JointChoice* choice) {
  const size_t joints = character.joints.size();
  std::vector<std::vector<double>> sums(mesh_count(character), std::vector<double>(joints, 0));
  for (size_t v = 0; v < character.influences.size(); ++v)
    for (const Influence& influence : character.influences[v])
      sums[mesh_of(character, v)][influence.joint] += static_cast<double>(influence.weight);
  std::map<std::vector<size_t>, size_t> known;
  std::vector<char> used(joints, 0);
  for (size_t m = 0; m < sums.size(); ++m) {
    std::vector<size_t> set;
    for (size_t j = 0; j < joints; ++j) {
      if (sums[m][j] <= kSomeWeight) continue;
      set.push_back(j);
      used[j] = 1;
    }
    if (set.empty()) {
      choice->set_of_mesh.push_back(SIZE_MAX);
      continue;
    }
    const auto [at, is_new] = known.emplace(set, choice->sets.size());
    if (is_new) choice->sets.push_back(set);
    choice->set_of_mesh.push_back(at->second);
  }
  for (size_t j = 0; j < joints; ++j)
    if (used[j] == 0) leave_out("no weight in the file", j, choice);
}

void choose_by_names(const Character& character, JointChoice* choice) {
  std::vector<uint8_t> roles = joint_verdicts(character.joints).roles;
  find_tips_without_mesh(character, &roles);
  const std::vector<uint8_t> named = roles;
  find_joints_beside_mesh(character, &roles);
  for (size_t j = 0; j < roles.size(); ++j) {
    const std::optional<bool>& deforms = character.joints[j].deforms;
    if (deforms) {
      if (!*deforms) leave_out("does not deform in the file", j, choice);
    } else if (roles[j] == SINEW_ROLE_END) {
      choice->tips.push_back(j);
    } else if (roles[j] < SINEW_ROLE_END && roles[j] != SINEW_ROLE_DEFORMS) {
      leave_out(named[j] == roles[j] ? joint_role_text(roles[j]) : "beside the mesh", j, choice);
    }
  }
}

}  // namespace

// A joint that the user names is neither left out nor a tip.
void apply_joint_flags(const std::vector<uint8_t>& joint_flags, JointChoice* choice) {
  if (names_those_that_deform(joint_flags)) {
    choice->flags = joint_flags;
    choice->left_out.clear();
    choice->tips.clear();
    choice->sets.clear();
    std::fill(choice->set_of_mesh.begin(), choice->set_of_mesh.end(), SIZE_MAX);
    for (size_t j = 0; j < joint_flags.size(); ++j)
      if ((joint_flags[j] & SINEW_JOINT_DEFORMS) == 0 || (joint_flags[j] & SINEW_JOINT_NEVER) != 0)
        choice->left_out.push_back({j, "not among the given joints"});
    return;
  }
  for (size_t j = 0; j < joint_flags.size(); ++j) {
    if ((joint_flags[j] & SINEW_JOINT_NEVER) == 0) continue;
    if ((choice->flags[j] & SINEW_JOINT_NEVER) == 0) choice->left_out.push_back({j, "excluded"});
    choice->flags[j] |= joint_flags[j];
    choice->tips.erase(std::remove(choice->tips.begin(), choice->tips.end(), j), choice->tips.end());
  }
}

JointChoice choose_joints(const Character& character, JointsFrom from, const std::vector<uint8_t>& joint_flags) {
  JointChoice choice;
  choice.flags.assign(character.joints.size(), 0);
  choice.set_of_mesh.clear();
  if (from == JointsFrom::kAuto) from = has_weights(character) ? JointsFrom::kOwn : JointsFrom::kNames;
  if (from == JointsFrom::kOwn && !has_weights(character)) from = JointsFrom::kNames;
  choice.from = from;
  if (from == JointsFrom::kOwn) choose_own(character, &choice);
  if (from == JointsFrom::kNames) choose_by_names(character, &choice);
  if (choice.left_out.size() == character.joints.size()) {  // a rig of controls alone: better all than none
    choice.flags.assign(character.joints.size(), 0);
    choice.left_out.clear();
  }
  choice.set_of_mesh.resize(mesh_count(character), SIZE_MAX);
  apply_joint_flags(joint_flags, &choice);
  return choice;
}

void restore_joints(const std::vector<size_t>& joints, const std::vector<uint8_t>& joint_flags, JointChoice* choice) {
  if (names_those_that_deform(joint_flags)) return;
  for (const size_t joint : joints) {
    if (!joint_flags.empty() && (joint_flags[joint] & SINEW_JOINT_NEVER) != 0) continue;
    choice->flags[joint] &= static_cast<uint8_t>(~SINEW_JOINT_NEVER);
    choice->tips.erase(std::remove(choice->tips.begin(), choice->tips.end(), joint), choice->tips.end());
    choice->left_out.erase(std::remove_if(choice->left_out.begin(), choice->left_out.end(),
                                          [joint](const LeftOutJoint& left) { return left.joint == joint; }),
                           choice->left_out.end());
    for (std::vector<size_t>& set : choice->sets)
      if (std::find(set.begin(), set.end(), joint) == set.end()) set.push_back(joint);
  }
}

std::vector<bool> kept_meshes(const Character& character, bool bind_props) {
  std::vector<bool> kept(character.meshes.size(), false);
  if (bind_props) return kept;
  const bool some_skinned = std::any_of(character.meshes.begin(), character.meshes.end(),
                                        [](const CharacterMesh& mesh) { return mesh.skinned; });
  for (size_t m = 0; m < kept.size(); ++m)
    kept[m] = !character.meshes[m].skinned && (some_skinned || character.meshes[m].carrier >= 0);
  return kept;
}

}  // namespace sinew
