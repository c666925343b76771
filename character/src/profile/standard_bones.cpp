// SPDX-License-Identifier: MIT
// Joints as bones of a convention, VRM's humanoid among them.
#include "profile/standard_bones.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "sinew/names.h"
#include "sinew_character/profile/profile.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/error.hpp"
#include "text/joint_names.hpp"

namespace sinew {
namespace {

class Humanoid {
 public:
  Humanoid(const std::vector<Joint>& joints, const BodyChains& most)
      : joints_(joints), most_(most), verdicts_(joint_verdicts(joints)), bones_(joints.size()) {}

  std::vector<std::optional<BodyBone>> bones() {
    trunk();
    chain(SINEW_CLASS_NECK, most_.neck);
    for (const uint8_t one : {SINEW_CLASS_HEAD, SINEW_CLASS_JAW}) give_first(one, 0);
    for (const int side : {1, -1}) {
      for (const uint8_t one :
           {SINEW_CLASS_CLAVICLE, SINEW_CLASS_UPPER_ARM, SINEW_CLASS_FOREARM, SINEW_CLASS_HAND, SINEW_CLASS_THIGH,
            SINEW_CLASS_CALF, SINEW_CLASS_FOOT, SINEW_CLASS_TOE, SINEW_CLASS_EYE})
        give_first(one, side);
      for (const uint8_t one :
           {SINEW_CLASS_THUMB, SINEW_CLASS_INDEX, SINEW_CLASS_MIDDLE, SINEW_CLASS_RING, SINEW_CLASS_PINKY})
        finger(one, side);
    }
    return bones_;
  }

 private:
  bool may(size_t joint) const {
    const uint8_t role = verdicts_.roles[joint];
    return role == SINEW_ROLE_DEFORMS || role == SINEW_ROLE_FINGER || role == SINEW_ROLE_FACE ||
           role == SINEW_ROLE_ROOT;
  }

  size_t depth(size_t joint) const {
    size_t steps = 0;
    for (int up = joints_[joint].parent; up >= 0; up = joints_[static_cast<size_t>(up)].parent) ++steps;
    return steps;
  }

  // Joints of a class and a side, nearest to the root first.
  std::vector<size_t> of_class(uint8_t joint_class, int side) const {
    std::vector<size_t> found;
    for (size_t j = 0; j < joints_.size(); ++j)
      if (verdicts_.classes[j] == joint_class && may(j) && (side == 0 || verdicts_.sides[j] == side))
        found.push_back(j);
    std::stable_sort(found.begin(), found.end(), [&](size_t a, size_t b) { return depth(a) < depth(b); });
    return found;
  }

  void give(size_t joint, uint8_t joint_class, int side, uint32_t index) { bones_[joint] = {joint_class, side, index}; }

  void give_first(uint8_t joint_class, int side) {
    const std::vector<size_t> found = of_class(joint_class, side);
    if (!found.empty()) give(found[0], joint_class, side, 0);
  }

  // The pelvis itself rather than a root that is called so.
  void pelvis() {
    const std::vector<size_t> found = of_class(SINEW_CLASS_PELVIS, 0);
    const auto best =
        std::find_if(found.begin(), found.end(), [&](size_t j) { return verdicts_.roles[j] != SINEW_ROLE_ROOT; });
    if (best != found.end())
      give(*best, SINEW_CLASS_PELVIS, 0, 0);
    else if (!found.empty())
      give(found[0], SINEW_CLASS_PELVIS, 0, 0);
  }

  void trunk() {
    pelvis();
    chain(SINEW_CLASS_SPINE, most_.trunk);
  }

  // Joints of a class below each other. Of more than `most` the first, the middle one and the last.
  void chain(uint8_t joint_class, size_t most) {
    std::vector<size_t> found;
    for (const size_t j : of_class(joint_class, 0))
      if (found.empty() || is_below(j, found.back())) found.push_back(j);
    if (found.size() > most)
      found = most == 1 ? std::vector<size_t>{found[0]}
                        : std::vector<size_t>{found[0], found[found.size() / 2], found.back()};
    for (size_t k = 0; k < found.size(); ++k) give(found[k], joint_class, 0, static_cast<uint32_t>(k));
  }

  bool is_below(size_t joint, size_t above) const {
    for (int up = joints_[joint].parent; up >= 0; up = joints_[static_cast<size_t>(up)].parent)
      if (static_cast<size_t>(up) == above) return true;
    return false;
  }

  // The last three: a palm's bone comes before them, but for the thumb's.
  void finger(uint8_t joint_class, int side) {
    std::vector<size_t> found = of_class(joint_class, side);
    if (found.size() > 3) found.erase(found.begin(), found.end() - 3);
    for (size_t k = 0; k < found.size(); ++k) give(found[k], joint_class, side, static_cast<uint32_t>(k));
  }

  const std::vector<Joint>& joints_;
  const BodyChains most_;
  JointVerdicts verdicts_;
  std::vector<std::optional<BodyBone>> bones_;
};

}  // namespace

std::vector<std::optional<BodyBone>> body_bones(const std::vector<Joint>& joints, const BodyChains& most) {
  return Humanoid(joints, most).bones();
}

std::vector<std::string> standard_bones(const std::vector<Joint>& joints, uint32_t naming) {
  const std::vector<std::optional<BodyBone>> bones =
      body_bones(joints, naming == SINEW_NAMING_VRM ? BodyChains{3, 1} : BodyChains{});
  std::vector<std::string> names(joints.size());
  for (size_t j = 0; j < bones.size(); ++j) {
    std::array<char, SINEW_JOINT_NAME_BYTES> name{};
    if (bones[j] && sinew_joint_standard_name(naming, bones[j]->joint_class, bones[j]->side, bones[j]->index,
                                              name.data()) == SINEW_OK)
      names[j] = name.data();
  }
  return names;
}

std::vector<std::string> vrm_bones(const std::vector<Joint>& joints, const std::string& name, bool zero) {
  std::vector<std::string> bones = standard_bones(joints, SINEW_NAMING_VRM);
  std::string missing;
  for (const std::string& bone : vrm_required_bones(zero))
    if (std::find(bones.begin(), bones.end(), bone) == bones.end()) missing += (missing.empty() ? "" : ", ") + bone;
  if (!missing.empty())
    throw Error(name + ": cannot write a VRM, no joint is the " + missing +
                "; rename joints, or rig a person with sinew rig");
  return bones;
}

// Names of a profile's convention.

namespace {

std::string in_convention(std::string name, const ProfileNames& names) {
  const size_t prefix = std::strlen(names.without);
  if (prefix > 0 && name.compare(0, prefix, names.without) == 0) name.erase(0, prefix);
  const size_t thumb = names.older_thumb ? name.find("Thumb") : std::string::npos;
  if (thumb != std::string::npos) {
    const std::string part = name.substr(thumb + 5);
    name = name.substr(0, thumb + 5) + (part == "Metacarpal" ? "Proximal" : part == "Proximal" ? "Intermediate" : part);
  }
  if (names.capital) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

std::vector<std::string> profile_names(const std::vector<Joint>& joints, const ProfileNames& names) {
  std::vector<std::string> standard(joints.size()), all;
  if (names.naming >= 0) standard = standard_bones(joints, static_cast<uint32_t>(names.naming));
  // Standard names come first, so that a joint's own that is one of them gets the number.
  std::vector<size_t> order;
  for (const bool own : {false, true})
    for (size_t j = 0; j < joints.size(); ++j)
      if (standard[j].empty() == own) order.push_back(j);
  for (const size_t j : order) {
    std::string name = standard[j].empty() ? joints[j].name : in_convention(standard[j], names);
    for (char& c : name)
      if (std::strchr(names.forbidden, c) != nullptr && c != 0) c = '_';
    all.push_back(std::move(name));
  }
  make_names_unique(&all);
  std::vector<std::string> out(joints.size());
  for (size_t k = 0; k < order.size(); ++k) out[order[k]] = std::move(all[k]);
  return out;
}

}  // namespace sinew
