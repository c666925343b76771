// SPDX-License-Identifier: MIT
// Parts by classes of joints, and how the torso lies.
#include "motion/body_parts.hpp"

#include <algorithm>
#include <cmath>

#include "motion/upright_body.hpp"
#include "sinew/rig.h"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr double kOnArms = 0.5;       // sine: what leans more goes on its arms
constexpr double kUprightLean = 0.7;  // sine

PartKind kind_of_class(uint8_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_HIP:
    case SINEW_CLASS_THIGH:
    case SINEW_CLASS_CALF:
    case SINEW_CLASS_FOOT:
    case SINEW_CLASS_TOE:
      return PartKind::kLeg;
    case SINEW_CLASS_CLAVICLE:
    case SINEW_CLASS_UPPER_ARM:
    case SINEW_CLASS_FOREARM:
    case SINEW_CLASS_HAND:
      return PartKind::kArm;
    case SINEW_CLASS_WING:
      return PartKind::kWing;
    case SINEW_CLASS_PELVIS:
    case SINEW_CLASS_SPINE:
      return PartKind::kTrunk;
    case SINEW_CLASS_NECK:
    case SINEW_CLASS_HEAD:
      return PartKind::kHead;
    case SINEW_CLASS_TAIL:
      return PartKind::kTail;
    case SINEW_CLASS_JAW:
    case SINEW_CLASS_EYE:
      return PartKind::kFace;
    case SINEW_CLASS_HAIR:
    case SINEW_CLASS_EAR:
      return PartKind::kHair;
    default:
      return PartKind::kNone;
  }
}

}  // namespace

BodyParts::BodyParts(const MapRig& rig, MaybeAxis up)
    : rig_(rig), up_(up.value_or(Axis::kY)), classes_(limb_classes(rig, up)), sides_(rig.joints.size(), 0) {
  const JointVerdicts verdicts = joint_verdicts(rig.joints);
  for (size_t j = 0; j < classes_.size(); ++j) {
    const bool known = verdicts.is_part(j) && is_limb(kind_of_class(verdicts.classes[j]));
    named_ = named_ || known;
    const bool face = verdicts.roles[j] == SINEW_ROLE_FACE;
    kinds_.push_back(kind_of_class(face ? verdicts.classes[j] : classes_[j]));
    sides_[j] = verdicts.sides[j];
  }
  measure_lean(up);
  if (named_ || stands_as_person()) gather();
}

// A human body that was laid over a skeleton without names says something where the skeleton stands as one.
bool BodyParts::stands_as_person() const {
  const std::optional<UprightBody> body = find_upright_body(rig_.joints, classes_);
  std::vector<Point3> positions;
  for (const Joint& joint : rig_.joints) positions.push_back(point(joint.position));
  return body && is_upright(*body, positions);
}

void BodyParts::gather() {
  const JointTree tree(rig_.joints);
  std::vector<int> part_of(rig_.joints.size(), -1);  // the nearest part at a joint or above it
  for (const size_t j : tree.parents_first) {
    const int above = rig_.joints[j].parent < 0 ? -1 : part_of[static_cast<size_t>(rig_.joints[j].parent)];
    part_of[j] = above;
    const bool end = !rig_.ends.empty() && rig_.ends[j] != 0;
    if (kinds_[j] == PartKind::kNone || end) continue;
    const bool on_limb = above >= 0 && is_limb(parts_[static_cast<size_t>(above)].kind);
    if (classes_[j] == SINEW_CLASS_TOE && on_limb)
      kinds_[j] = parts_[static_cast<size_t>(above)].kind;  // of a front leg
    const auto same = [&](const BodyPart& part) { return part.kind == kinds_[j]; };
    // One trunk and one head, whatever lies between their joints; limbs and tails by connected components.
    const bool one = kinds_[j] == PartKind::kTrunk || kinds_[j] == PartKind::kHead;
    const auto found = one ? std::find_if(parts_.begin(), parts_.end(), same)
                       : above >= 0 && same(parts_[static_cast<size_t>(above)]) ? parts_.begin() + above
                                                                                : parts_.end();
    if (found != parts_.end()) {
      found->joints.push_back(static_cast<int>(j));
      part_of[j] = static_cast<int>(found - parts_.begin());
      continue;
    }
    part_of[j] = static_cast<int>(parts_.size());
    parts_.push_back({kinds_[j], sides_[j], {static_cast<int>(j)}});
  }
}

bool BodyParts::has(PartKind kind) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const BodyPart& part) { return part.kind == kind; });
}

std::string BodyParts::limb_word(PartKind kind) const {
  const bool lies = lean_ && *lean_ < kOnArms;
  if (kind == PartKind::kWing) return "wing";
  if (kind == PartKind::kArm) return lies ? "front leg" : "arm";
  return lies && has(PartKind::kArm) ? "hind leg" : "leg";
}

std::string BodyParts::text(const BodyPart& part) const {
  const uint8_t first = class_of(part.joints[0]);
  switch (part.kind) {
    case PartKind::kTrunk:
      return "the torso";
    case PartKind::kHead:
      return "the head";
    case PartKind::kTail:
      return "the tail";
    case PartKind::kFace:
      return first == SINEW_CLASS_EYE ? "an eye" : "the jaw";
    case PartKind::kHair:
      return first == SINEW_CLASS_EAR ? "an ear" : "the hair";
    default:
      return (part.side > 0 ? "the left " : part.side < 0 ? "the right " : "one ") + limb_word(part.kind);
  }
}

std::string BodyParts::text_of_pair(PartKind kind) const { return "the " + limb_word(kind) + "s"; }

// Where joints of a class begin, in the mean.
std::optional<Point3> BodyParts::middle_of(uint8_t joint_class) const {
  Point3 sum{};
  double count = 0;
  for (size_t j = 0; j < classes_.size(); ++j) {
    const int parent = rig_.joints[j].parent;
    if (classes_[j] != joint_class || (parent >= 0 && classes_[static_cast<size_t>(parent)] == joint_class)) continue;
    sum = sum + point(rig_.joints[j].position);
    count += 1;
  }
  if (!(count > 0)) return std::nullopt;
  return (1 / count) * sum;
}

// The middle of the last joints of legs.
Point3 BodyParts::leg_ends() const {
  const auto is_leg = [&](size_t j) {
    return classes_[j] == SINEW_CLASS_THIGH || classes_[j] == SINEW_CLASS_CALF || classes_[j] == SINEW_CLASS_FOOT;
  };
  std::vector<char> ends(classes_.size(), 0);
  for (size_t j = 0; j < classes_.size(); ++j) ends[j] = is_leg(j) ? 1 : 0;
  for (size_t j = 0; j < classes_.size(); ++j)
    if (is_leg(j) && rig_.joints[j].parent >= 0) ends[static_cast<size_t>(rig_.joints[j].parent)] = 0;
  Point3 sum{};
  double count = 0;
  for (size_t j = 0; j < classes_.size(); ++j) {
    if (ends[j] == 0) continue;
    sum = sum + point(rig_.joints[j].position);
    count += 1;
  }
  return (1 / std::max(1.0, count)) * sum;
}

void BodyParts::measure_lean(MaybeAxis up) {
  const std::optional<Point3> legs = middle_of(SINEW_CLASS_THIGH);
  std::optional<Point3> top = middle_of(SINEW_CLASS_UPPER_ARM);
  if (!top) top = middle_of(SINEW_CLASS_HEAD);
  if (!top) top = middle_of(SINEW_CLASS_NECK);
  if (!legs || !top) return;
  size_t axis = axis_index(up_);
  if (!up) {
    const Point3 down = leg_ends() - *legs;
    for (size_t i = 0; i < 3; ++i) axis = std::abs(down[i]) > std::abs(down[axis]) ? i : axis;
  }
  lean_ = unit(*top - *legs)[axis];
  if (*lean_ > kUprightLean) up_ = static_cast<Axis>(axis);
}

}  // namespace sinew
