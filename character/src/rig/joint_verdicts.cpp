// SPDX-License-Identifier: MIT
// Joints as arrays, into the engine and back.
#include "sinew_character/rig/joint_verdicts.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "sinew/sinew.hpp"
#include "sinew_formats/error.hpp"
#include "votes/joint_class.hpp"

namespace sinew {

JointVerdicts joint_verdicts(const std::vector<Joint>& joints, const std::vector<uint8_t>& follows) {
  JointVerdicts out;
  const size_t count = joints.size();
  if (count == 0) return out;
  std::vector<const char*> names;
  std::vector<int32_t> parents;
  std::vector<float> positions;
  for (const Joint& joint : joints) {
    names.push_back(joint.name.c_str());
    parents.push_back(joint.parent);
    positions.insert(positions.end(), {joint.position.x, joint.position.y, joint.position.z});
  }
  const auto check = [&](sinew_status status) {
    if (status != SINEW_OK) throw Error(std::string("cannot read the joints' names: ") + sinew_status_text(status));
  };
  sinew_skeleton named = SINEW_INIT(sinew_skeleton);
  named.positions = positions.data();
  named.parents = parents.data();
  named.joint_count = static_cast<uint32_t>(count);
  named.names = names.data();
  out.classes.resize(count);
  out.roles.resize(count);
  out.sides.resize(count);
  out.numbers.resize(count);
  out.partners.resize(count);
  out.images.resize(count);
  sinew_joint_verdicts verdicts = SINEW_INIT(sinew_joint_verdicts);
  verdicts.classes = out.classes.data();
  verdicts.roles = out.roles.data();
  verdicts.sides = out.sides.data();
  verdicts.numbers = out.numbers.data();
  verdicts.partners = out.partners.data();
  verdicts.images = out.images.data();
  size_t bytes = 0;
  check(sinew_joint_classes_workspace_size(named.joint_count, &bytes));
  Workspace workspace;
  check(workspace.reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE);
  check(sinew_joint_classes(&named, follows.empty() ? nullptr : follows.data(), workspace.data(), workspace.size(),
                            &verdicts));
  out.mirrored = verdicts.mirrored != 0;
  out.mirror_axis = verdicts.mirror_axis;
  std::copy_n(verdicts.mirror_planes, 3, out.mirror_planes.begin());
  return out;
}

std::vector<uint8_t> follows_of(const Character& character) {
  std::vector<uint8_t> follows(character.joints.size(), SINEW_FOLLOWS_NONE);
  bool any = false;
  for (const auto& row : character.influences) {
    for (const Influence& influence : row) {
      if (!(influence.weight > 0)) continue;
      follows[influence.joint] = SINEW_FOLLOWS_SOME;
      any = true;
    }
  }
  if (!any) follows.clear();
  return follows;
}

bool names_bone_end(std::string name) {
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.pop_back();
  constexpr std::string_view kEnding = "_end";
  if (name.size() < kEnding.size()) return false;
  return std::equal(kEnding.begin(), kEnding.end(), name.end() - static_cast<std::ptrdiff_t>(kEnding.size()),
                    [](char a, char b) { return a == b || a - 'a' + 'A' == b; });
}

const char* joint_role_text(uint32_t role) {
  constexpr std::array<const char*, 9> kNames = {"deforms", "root", "control", "slot",  "end",
                                                 "twist",   "face", "finger",  "helper"};
  return role < kNames.size() ? kNames[role] : "?";
}

const char* joint_class_text(uint32_t joint_class) {
  constexpr std::array<const char*, 27> kNames = {
      "pelvis", "spine", "neck",  "head",   "clavicle", "upperarm", "forearm", "hand", "hip",
      "thigh",  "calf",  "foot",  "toe",    "tail",     "wing",     "ear",     "hair", "other",
      "tip",    "thumb", "index", "middle", "ring",     "pinky",    "eye",     "jaw",  "prop"};
  return joint_class < kNames.size() ? kNames[joint_class] : "?";
}

}  // namespace sinew
