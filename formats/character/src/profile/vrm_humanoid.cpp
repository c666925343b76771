// SPDX-License-Identifier: MIT
// Joints as humanoid bones of VRM 1.0.
#include <algorithm>
#include <array>

#include "sinew/names.h"
#include "sinew_character/joint_verdicts.hpp"
#include "sinew_character/profile.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

class Humanoid {
 public:
  explicit Humanoid(const std::vector<Joint>& joints)
      : joints_(joints), verdicts_(joint_verdicts(joints)), bones_(joints.size()) {}

  std::vector<std::string> bones() {
    trunk();
    for (const uint8_t one : {SINEW_CLASS_NECK, SINEW_CLASS_HEAD, SINEW_CLASS_JAW}) give_first(one, 0);
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

  // Of a class and a side, nearest to the root first.
  std::vector<size_t> of_class(uint8_t joint_class, int side) const {
    std::vector<size_t> found;
    for (size_t j = 0; j < joints_.size(); ++j)
      if (verdicts_.classes[j] == joint_class && may(j) && (side == 0 || verdicts_.sides[j] == side))
        found.push_back(j);
    std::stable_sort(found.begin(), found.end(), [&](size_t a, size_t b) { return depth(a) < depth(b); });
    return found;
  }

  void give(size_t joint, uint8_t joint_class, int side, uint32_t index) {
    std::array<char, SINEW_JOINT_NAME_BYTES> name{};
    if (sinew_joint_standard_name(SINEW_NAMING_VRM, joint_class, side, index, name.data()) == SINEW_OK)
      bones_[joint] = name.data();
  }

  void give_first(uint8_t joint_class, int side) {
    const std::vector<size_t> found = of_class(joint_class, side);
    if (!found.empty()) give(found[0], joint_class, side, 0);
  }

  // Of a longer trunk the first is the spine, the last the upper chest, and the middle one of the others the chest.
  void trunk() {
    give_first(SINEW_CLASS_PELVIS, 0);
    std::vector<size_t> spine;
    for (const size_t j : of_class(SINEW_CLASS_SPINE, 0))
      if (spine.empty() || is_below(j, spine.back())) spine.push_back(j);
    if (spine.size() > 3) spine = {spine[0], spine[spine.size() / 2], spine.back()};
    for (size_t k = 0; k < spine.size(); ++k) give(spine[k], SINEW_CLASS_SPINE, 0, static_cast<uint32_t>(k));
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
  JointVerdicts verdicts_;
  std::vector<std::string> bones_;
};

}  // namespace

std::vector<std::string> vrm_bones(const std::vector<Joint>& joints, const std::string& name) {
  std::vector<std::string> bones = Humanoid(joints).bones();
  std::string missing;
  for (const std::string& bone : vrm_required_bones())
    if (std::find(bones.begin(), bones.end(), bone) == bones.end()) missing += (missing.empty() ? "" : ", ") + bone;
  if (!missing.empty())
    throw Error(name + ": cannot be a VRM, no joint is its " + missing + "; rename joints, or sinew rig a person");
  return bones;
}

}  // namespace sinew
