// SPDX-License-Identifier: MIT
// Limbs by anatomy and names as limits have them, trunk and fingers by names as profiles have them.
#include "sinew_character/profile/controls.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "motion/upright_body.hpp"
#include "profile/standard_bones.hpp"
#include "sinew/rig.h"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

const char* finger_word(uint8_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_THUMB:
      return "thumb";
    case SINEW_CLASS_INDEX:
      return "index";
    case SINEW_CLASS_MIDDLE:
      return "middle";
    case SINEW_CLASS_RING:
      return "ring";
    default:
      return "pinky";
  }
}

class ControlFinder {
 public:
  explicit ControlFinder(const Character& character)
      : joints_(character.joints),
        verdicts_(joint_verdicts(character.joints)),
        classes_(limb_classes(map_rig_of(character), {})) {}

  ControlRig find() {
    find_frame();
    for (const bool legs : {true, false})
      for (const UprightLimb& limb : find_limbs(joints_, classes_, legs)) add_limb(limb, legs);
    add_trunk_and_fingers();
    tell();
    return std::move(rig_);
  }

 private:
  Point3 at(int j) const { return point(joints_[static_cast<size_t>(j)].position); }
  int parent(int j) const { return joints_[static_cast<size_t>(j)].parent; }

  void find_frame() {
    if (const std::optional<UprightBody> body = find_upright_body(joints_, classes_)) {
      frame_ = body_frame(joints_, *body, {});
    } else {  // more or fewer legs
      const Rotation axes = body_axes(joints_);
      frame_.left = {axes[0], axes[3], axes[6]};
      frame_.up = {axes[1], axes[4], axes[7]};
      frame_.front = {axes[2], axes[5], axes[8]};
    }
    rig_.up = frame_.up;
    rig_.front = frame_.front;
  }

  int side_of(int joint) const { return verdicts_.sides[static_cast<size_t>(joint)]; }

  std::string name_of(const std::string& word, int side) {
    const std::string name = word + (side > 0 ? ".left" : side < 0 ? ".right" : "");
    const int count = ++named_[name];
    return count == 1 ? name : name + "." + std::to_string(count);
  }

  void add_limb(const UprightLimb& found, bool leg) {
    ControlLimb limb;
    for (int j = found.end; j >= 0 && j != found.upper; j = parent(j)) limb.joints.push_back(j);
    limb.joints.push_back(found.upper);
    std::reverse(limb.joints.begin(), limb.joints.end());
    const Point3 upper = at(found.middle) - at(found.upper), lower = at(found.end) - at(found.middle);
    const double size = length(upper) + length(lower);
    // Two bones that pull need lengths.
    if (!(std::min(length(upper), length(lower)) > 0.02 * size)) return;
    limb.leg = leg;
    limb.side = side_of(found.upper);
    limb.middle = found.middle;
    if (leg) limb.ball = ball_below(found.end);
    if (const std::optional<Point3> to = bend_side(unit(upper), unit(lower), frame_.front, leg))
      limb.pole = -1.0 * unit(across(*to, unit(at(found.end) - at(found.upper))));
    limb.name = name_of(leg ? "leg" : "arm", limb.side);
    if (!(length(limb.pole) > 0))
      rig_.notes.push_back(limb.name + ": its bend direction is unknown, as it is straight at rest; bend it slightly");
    rig_.limbs.push_back(std::move(limb));
  }

  // The joint that toes rotate about, elsewhere than the foot's.
  int ball_below(int foot) const {
    for (size_t j = 0; j < joints_.size(); ++j) {
      const int joint = static_cast<int>(j);
      if (parent(joint) == foot && verdicts_.classes[j] == SINEW_CLASS_TOE && !verdicts_.is_end(j) &&
          length(at(joint) - at(foot)) > 0)
        return joint;
    }
    return -1;
  }

  void add_trunk_and_fingers() {
    const std::vector<std::optional<BodyBone>> bones = body_bones(joints_);
    std::map<std::pair<int, uint8_t>, std::vector<int>> fingers;
    std::vector<std::pair<uint32_t, int>> spine, neck;
    for (size_t j = 0; j < bones.size(); ++j) {
      if (!bones[j]) continue;
      const int joint = static_cast<int>(j);
      const BodyBone& bone = *bones[j];
      if (bone.joint_class == SINEW_CLASS_PELVIS) rig_.hips = joint;
      if (bone.joint_class == SINEW_CLASS_HEAD) rig_.head = joint;
      if (bone.joint_class == SINEW_CLASS_SPINE) spine.push_back({bone.index, joint});
      if (bone.joint_class == SINEW_CLASS_NECK) neck.push_back({bone.index, joint});
      if (bone.joint_class < SINEW_CLASS_THUMB || bone.joint_class > SINEW_CLASS_PINKY) continue;
      std::vector<int>& finger = fingers[{-bone.side, bone.joint_class}];
      finger.resize(std::max<size_t>(finger.size(), bone.index + 1), -1);
      finger[bone.index] = joint;
    }
    std::sort(spine.begin(), spine.end());
    std::sort(neck.begin(), neck.end());
    for (const auto& [index, joint] : spine) rig_.spine.push_back(joint);
    for (const auto& [index, joint] : neck) rig_.neck.push_back(joint);
    for (auto& [key, joints] : fingers) add_finger(key.second, -key.first, std::move(joints));
    for (ControlFinger& finger : rig_.fingers) finger.axis = curl_axis(finger);
  }

  void add_finger(uint8_t joint_class, int side, std::vector<int> joints) {
    ControlFinger finger;
    finger.side = side;
    finger.joints = std::move(joints);
    finger.hand = parent(finger.joints[0]);
    while (finger.hand >= 0 && verdicts_.classes[static_cast<size_t>(finger.hand)] != SINEW_CLASS_HAND)
      finger.hand = parent(finger.hand);
    finger.name = name_of(finger_word(joint_class), side);
    rig_.fingers.push_back(std::move(finger));
  }

  // Along the finger at rest; the bone before it where it has one joint.
  Point3 along(const ControlFinger& finger) const {
    const int first = finger.joints.front(), last = finger.joints.back();
    if (first != last) return unit(at(last) - at(first));
    return parent(first) < 0 ? Point3{} : unit(at(first) - at(parent(first)));
  }

  // Where the palm is: across fingers of one hand that lie beside each other, else below, as of arms that are held out.
  Point3 palm(const ControlFinger& finger) const {
    const ControlFinger *first = nullptr, *last = nullptr;
    for (const ControlFinger& other : rig_.fingers) {
      if (other.side != finger.side || other.hand != finger.hand || other.name.rfind("thumb", 0) == 0) continue;
      if (first == nullptr) first = &other;
      last = &other;
    }
    if (first == nullptr || first == last || finger.side == 0) return -1.0 * frame_.up;
    const Point3 row = at(last->joints.front()) - at(first->joints.front());  // from the index finger outwards
    const Point3 down = cross(row, along(*first));
    return unit(finger.side > 0 ? down : -1.0 * down);
  }

  ControlDirection curl_axis(const ControlFinger& finger) const {
    const Point3 direction = along(finger);
    Point3 to = palm(finger);
    if (finger.name.rfind("thumb", 0) == 0) {  // goes to where the other fingers begin
      Point3 middle{};
      double count = 0;
      for (const ControlFinger& other : rig_.fingers)
        if (other.hand == finger.hand && other.side == finger.side && &other != &finger) {
          middle = middle + at(other.joints.front());
          ++count;
        }
      if (count > 0) to = (1 / count) * middle - at(finger.joints.front());
    }
    return unit(cross(direction, unit(across(to, direction))));
  }

  void tell() {
    const bool legs = std::any_of(rig_.limbs.begin(), rig_.limbs.end(), [](const auto& limb) { return limb.leg; });
    const bool arms = std::any_of(rig_.limbs.begin(), rig_.limbs.end(), [](const auto& limb) { return !limb.leg; });
    if (!legs || !arms)
      rig_.notes.push_back(std::string("no ") +
                           (legs   ? "arms"
                            : arms ? "legs"
                                   : "legs and no arms") +
                           " among the joints, so they get no IK");
    if (rig_.spine.empty() && rig_.head < 0)
      rig_.notes.push_back("no joint is called a spine or a head, so joints rotate one by one");
  }

  const std::vector<Joint>& joints_;
  const JointVerdicts verdicts_;
  const std::vector<uint8_t> classes_;
  BodyFrame frame_;
  std::map<std::string, int> named_;  // how many are called so
  ControlRig rig_;
};

}  // namespace

ControlRig find_controls(const Character& character) {
  if (character.joints.empty()) return {};
  return ControlFinder(character).find();
}

}  // namespace sinew
