// SPDX-License-Identifier: MIT
// The parts of a skeleton's body as users call them: legs, arms, wings, trunk, head, tail, hair.
#ifndef SINEW_CHARACTER_MOTION_BODY_PARTS_HPP
#define SINEW_CHARACTER_MOTION_BODY_PARTS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {

enum class PartKind : uint8_t { kLeg, kArm, kWing, kTrunk, kHead, kTail, kFace, kHair, kNone };

inline bool is_limb(PartKind kind) {
  return kind == PartKind::kLeg || kind == PartKind::kArm || kind == PartKind::kWing;
}

struct BodyPart {
  PartKind kind = PartKind::kNone;
  int side = 0;             // 1 left, -1 right, 0 in the middle or unknown
  std::vector<int> joints;  // without ends, parents first
};

// The parts of a skeleton: connected joints of one kind, by their classes. None where neither names nor an upright
// stance tell.
class BodyParts {
 public:
  BodyParts(const MapRig& rig, MaybeAxis up);

  const std::vector<BodyPart>& all() const { return parts_; }
  bool has(PartKind kind) const;
  PartKind kind_of(int joint) const { return kinds_[static_cast<size_t>(joint)]; }
  int side_of(int joint) const { return sides_[static_cast<size_t>(joint)]; }
  uint8_t class_of(int joint) const { return classes_[static_cast<size_t>(joint)]; }
  // At least one limb joint is classified by name; otherwise a human body was fitted to the skeleton.
  bool named() const { return named_; }
  // Sine of the torso's direction over the horizon, from the legs on; empty without legs, or without arms, head and neck.
  const std::optional<double>& lean() const { return lean_; }
  // As given, else along the legs of an upright body, else y.
  Axis up() const { return up_; }
  // "the left front leg", "the head", "a leg"; of a pair "the front legs".
  std::string text(const BodyPart& part) const;
  std::string text_of_pair(PartKind kind) const;

 private:
  std::string limb_word(PartKind kind) const;
  std::optional<Point3> middle_of(uint8_t joint_class) const;
  Point3 leg_ends() const;
  void measure_lean(MaybeAxis up);
  void gather();
  bool stands_as_person() const;

  const MapRig& rig_;
  Axis up_;
  std::vector<uint8_t> classes_;  // [J] sinew_joint_class
  std::vector<PartKind> kinds_;   // [J]
  std::vector<int> sides_;        // [J]
  std::vector<BodyPart> parts_;
  bool named_ = false;
  std::optional<double> lean_;
};

}  // namespace sinew
#endif
