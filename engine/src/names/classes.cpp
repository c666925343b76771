// SPDX-License-Identifier: MIT
// Classes of joints: the part that a name says, and where it leaves a choice, what is below and above.
#include "names/named_joints.hpp"

namespace sinew::names {
namespace {

// Joints between a joint and its leaves.
enum Below : uint8_t { kAny = 1, kUpLegBelow = 2, kLegBelow = 4 };

struct Verdict {
  uint8_t joint_class = SINEW_CLASS_OTHER;
  uint8_t role = SINEW_ROLE_DEFORMS;
};

Verdict front_leg(Part part, uint8_t below) {
  switch (part) {
    case Part::kShoulder:
    case Part::kHipJoint:
    case Part::kHips:
      return {SINEW_CLASS_CLAVICLE};
    case Part::kLeg:
      return {static_cast<uint8_t>((below & kUpLegBelow) != 0 ? SINEW_CLASS_CLAVICLE : SINEW_CLASS_UPPER_ARM)};
    case Part::kUpLeg:
      return {SINEW_CLASS_UPPER_ARM};
    case Part::kLowLeg:
      return {SINEW_CLASS_FOREARM};
    case Part::kFoot:
      return {SINEW_CLASS_HAND};
    default:
      return {SINEW_CLASS_TOE};
  }
}

Verdict class_by_name(const JointName& name, uint8_t below) {
  const bool hip_like = (below & kUpLegBelow) != 0;
  const auto is = [](int joint_class) { return Verdict{static_cast<uint8_t>(joint_class)}; };
  const auto detail = [](int joint_class, int role) {
    return Verdict{static_cast<uint8_t>(joint_class), static_cast<uint8_t>(role)};
  };
  if (name.digit) return detail(SINEW_CLASS_TOE, SINEW_ROLE_HELPER);
  const bool leg =
      (name.part >= Part::kHipJoint && name.part <= Part::kShoulder) || (name.part == Part::kHips && name.side != 0);
  if (leg && name.has(kFront)) return front_leg(name.part, below);
  const bool hind = name.has(kHind);
  switch (name.part) {
    case Part::kThumb:
      return detail(SINEW_CLASS_THUMB, SINEW_ROLE_FINGER);
    case Part::kIndex:
      return detail(SINEW_CLASS_INDEX, SINEW_ROLE_FINGER);
    case Part::kMiddle:
      return detail(SINEW_CLASS_MIDDLE, SINEW_ROLE_FINGER);
    case Part::kRing:
      return detail(SINEW_CLASS_RING, SINEW_ROLE_FINGER);
    case Part::kPinky:
      return detail(SINEW_CLASS_PINKY, SINEW_ROLE_FINGER);
    case Part::kFingers:
    case Part::kMeta:
      return detail(SINEW_CLASS_OTHER, SINEW_ROLE_FINGER);
    case Part::kFace:
      return detail(SINEW_CLASS_OTHER, SINEW_ROLE_FACE);
    case Part::kEye:
      return detail(SINEW_CLASS_EYE, SINEW_ROLE_FACE);
    case Part::kJaw:
      return detail(SINEW_CLASS_JAW, SINEW_ROLE_FACE);
    case Part::kBreast:
      return detail(SINEW_CLASS_OTHER, SINEW_ROLE_HELPER);
    case Part::kHair:
      return is(SINEW_CLASS_HAIR);
    case Part::kEar:
      return is(SINEW_CLASS_EAR);
    case Part::kWing:
      return is(SINEW_CLASS_WING);
    case Part::kTail:
      return is(SINEW_CLASS_TAIL);
    case Part::kHead:
      return is(SINEW_CLASS_HEAD);
    case Part::kNeck:
      return is(SINEW_CLASS_NECK);
    case Part::kLowerArm:
      return is(SINEW_CLASS_FOREARM);
    case Part::kUpperArm:
      return is(SINEW_CLASS_UPPER_ARM);
    case Part::kHand:
    case Part::kProp:
      return is(SINEW_CLASS_HAND);
    case Part::kHipJoint:
      return is(SINEW_CLASS_HIP);
    case Part::kUpLeg:
      return is(SINEW_CLASS_THIGH);
    case Part::kLowLeg:
      return is(SINEW_CLASS_CALF);
    case Part::kFoot:
      return is(SINEW_CLASS_FOOT);
    case Part::kToe:
      return is(SINEW_CLASS_TOE);
    case Part::kLeg:
      if (hind) return is(hip_like ? SINEW_CLASS_HIP : SINEW_CLASS_THIGH);
      return is(name.side != 0 && (below & kAny) != 0 ? SINEW_CLASS_CALF : SINEW_CLASS_THIGH);
    case Part::kShoulder:
      return is(hind ? SINEW_CLASS_HIP : SINEW_CLASS_CLAVICLE);
    case Part::kHips:
      if (name.side != 0) return is(hip_like ? SINEW_CLASS_HIP : SINEW_CLASS_THIGH);
      return is(SINEW_CLASS_PELVIS);
    case Part::kSpine:
      return is(SINEW_CLASS_SPINE);
    default:
      return is(SINEW_CLASS_OTHER);
  }
}

Verdict verdict_on(const JointName& name, uint8_t below) {
  Verdict verdict = class_by_name(name, below);
  if (verdict.role != SINEW_ROLE_DEFORMS) return verdict;
  if (name.has(kTwist | kHalf)) verdict.role = SINEW_ROLE_TWIST;
  if (name.helper) verdict.role = SINEW_ROLE_HELPER;
  return verdict;
}

class ClassFinder {
 public:
  explicit ClassFinder(NamedJoints* joints) : s_(*joints) {}

  void find() {
    look_below();
    bool from_zero = false;
    for (int32_t j = 0; j < s_.n; ++j) from_zero = from_zero || s_.names[j].finger == 0;
    for (int32_t j = 0; j < s_.n; ++j) {
      const JointName& name = s_.names[j];
      Verdict verdict = verdict_on(name, s_.marks[j]);
      const int finger = name.finger - (from_zero ? 0 : 1);
      if (name.part == Part::kFingers && !name.digit && name.finger >= 0 && finger >= 0 && finger < 5)
        verdict.joint_class = static_cast<uint8_t>(SINEW_CLASS_THUMB + finger);
      s_.classes[j] = verdict.joint_class;
      if (s_.deforms(j)) s_.roles[j] = verdict.role;
    }
    legs_without_thighs();
    shoulders_of_elbows();
    hands_of_hands();
    tell_spine_apart();
    for (int32_t i = 0; i < s_.n; ++i) {
      const int32_t j = s_.order[i];
      if (s_.is_end(j)) s_.classes[j] = s_.classes[s_.parents[j]];
    }
  }

 private:
  bool is_part(int32_t j) const { return s_.deforms(j) || s_.roles[j] == SINEW_ROLE_ROOT; }
  // Weights tell what counts, else every joint that ends no bone.
  bool counts(int32_t j) const { return s_.follows != nullptr ? !s_.is_bare(j) : !s_.is_end(j); }

  void look_below() {
    for (int32_t j = 0; j < s_.n; ++j) s_.marks[j] = 0;
    for (int32_t i = s_.n - 1; i >= 0; --i) {
      const int32_t j = s_.order[i], p = s_.parents[j];
      if (p < 0) continue;
      const Part part = s_.names[j].part;
      uint8_t own = s_.marks[j];
      if (counts(j)) {
        own |= kAny;
        if (part == Part::kUpLeg) own |= kUpLegBelow;
        if (part == Part::kLowLeg || part == Part::kLeg) own |= kLegBelow;
      }
      s_.marks[p] |= own;
    }
  }

  // The joint nearest above that is a part of the body, -1 without one.
  int32_t part_above(int32_t j) const {
    int32_t above = s_.parents[j];
    while (above >= 0 && !is_part(above)) above = s_.parents[above];
    return above;
  }

  // Leg1.L, Leg2.L: a leg above a leg, and no thigh above it.
  void legs_without_thighs() {
    for (int32_t i = 0; i < s_.n; ++i) {
      const int32_t j = s_.order[i];
      if (s_.names[j].part != Part::kLeg || s_.classes[j] != SINEW_CLASS_CALF || (s_.marks[j] & kLegBelow) == 0)
        continue;
      const int32_t above = part_above(j);
      const uint8_t c = above < 0 ? uint8_t{SINEW_CLASS_OTHER} : s_.classes[above];
      if (c != SINEW_CLASS_THIGH && c != SINEW_CLASS_CALF) s_.classes[j] = SINEW_CLASS_THIGH;
    }
  }

  // LeftCollar, LeftShoulder, LeftElbow: the joint above an elbow is an upper arm.
  void shoulders_of_elbows() {
    for (int32_t j = 0; j < s_.n; ++j) {
      if (s_.classes[j] != SINEW_CLASS_FOREARM || !is_part(j) || s_.names[j].has(kFront)) continue;
      const int32_t above = part_above(j);
      if (above >= 0 && s_.classes[above] == SINEW_CLASS_CLAVICLE && s_.names[above].part == Part::kShoulder)
        s_.classes[above] = SINEW_CLASS_UPPER_ARM;
    }
  }

  // Palms and what a hand holds.
  void hands_of_hands() {
    for (int32_t i = 0; i < s_.n; ++i) {
      const int32_t j = s_.order[i];
      if (s_.classes[j] != SINEW_CLASS_HAND || !s_.deforms(j)) continue;
      const int32_t above = part_above(j);
      if (above >= 0 && s_.classes[above] == SINEW_CLASS_HAND) s_.roles[j] = SINEW_ROLE_HELPER;
    }
  }

  int32_t spine_above(uint8_t wanted) const {
    for (int32_t j = 0; j < s_.n; ++j) {
      const int32_t above = s_.classes[j] == wanted && is_part(j) ? part_above(j) : -1;
      if (above >= 0 && s_.classes[above] == SINEW_CLASS_SPINE) return above;
    }
    return -1;
  }

  bool has_class(uint8_t wanted) const {
    for (int32_t j = 0; j < s_.n; ++j) {
      if (s_.classes[j] == wanted && is_part(j)) return true;
    }
    return false;
  }

  // Rigify's trunk is spine from the pelvis to the head: the parent of the thighs is the pelvis, and beyond the joint
  // with the clavicles come the neck and, last, the head.
  void tell_spine_apart() {
    const int32_t legs = spine_above(SINEW_CLASS_THIGH), arms = spine_above(SINEW_CLASS_CLAVICLE);
    if (legs < 0 || arms < 0 || has_class(SINEW_CLASS_PELVIS)) return;
    if (!has_class(SINEW_CLASS_NECK) && !has_class(SINEW_CLASS_HEAD)) {
      int32_t last = arms;
      for (bool more = true; more;) {
        more = false;
        for (int32_t j = 0; j < s_.n && !more; ++j) {
          more = s_.classes[j] == SINEW_CLASS_SPINE && s_.deforms(j) && part_above(j) == last;
          if (!more) continue;
          s_.classes[j] = SINEW_CLASS_NECK;
          last = j;
        }
      }
      if (last != arms) s_.classes[last] = SINEW_CLASS_HEAD;
    }
    s_.classes[legs] = SINEW_CLASS_PELVIS;
  }

  NamedJoints& s_;
};

}  // namespace

void find_classes(NamedJoints* joints) { ClassFinder(joints).find(); }

}  // namespace sinew::names
