// SPDX-License-Identifier: MIT
// The skeleton and the hands that a rigged character teaches and that predicted ones are measured by: the joints that move its
// body and the fingers of its hands, whatever else its maker put into the file.
#ifndef SINEW_DATA_SETS_TARGET_SKELETON_HPP
#define SINEW_DATA_SETS_TARGET_SKELETON_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "votes/joint_class.hpp"

namespace sinew {

struct TargetJoint {
  std::string name;                                        // a bone end: its joint's with "_end" behind
  std::array<double, 3> position = {};                     // rest pose, the mesh's units
  int parent = -1;                                         // index into TargetSkeleton::joints, -1 for the root
  rigging::JointClass joint_class = rigging::kClassOther;  // a bone end: its joint's
  bool tip = false;                                        // a bone end: where a leaf's bone stops, no joint of its own
  uint32_t source = 0;  // joint of the character whose position it has; a bone end: its joint's
  double mass = 0;      // share of the surface that it moves, 0..1; all joints together 1; a bone end: 0
};

struct TargetSkeleton {
  std::vector<TargetJoint> joints;  // in the character's order, then the bone ends; a parent may come later
  std::vector<uint32_t> owners;     // [J] for every joint of the character the target joint that has its weight
  double side = 0;                  // longest side of the mesh
};

// 1. Details (joint_verdicts(): fingers, faces, halves of limbs, palms) hand their weight to the nearest ancestor that is none.
// 2. A joint is bound if it has 0.2 % of the vertices or of the surface, by weight. Bound joints stay, and what lies
//    between two of them.
// 3. An unbound joint at the top goes, again and again: the child with the most surface below becomes the root, the
//    others hang on the nearest joint below that.
// 4. A child nearer than 1 % of the side to its parent, or 8 % where both are pelvises, is merged into it; the position of
//    the heavier one stays.
// 5. Every leaf gets a bone end: the file's, where exactly one weightless leaf hangs on it further than 1 % away; else
//    0.85 of the distance to the end (98 % quantile) of its vertices, in their mean direction. None where that is below 1 %.
// Throws Error for a character without joints, weights or extent, or with indices that lead nowhere.
TargetSkeleton target_skeleton(const Character& character);

// As joints of a file, in the same order. Names are unique, and no leaf but a bone end is named as one.
std::vector<Joint> target_joints(const TargetSkeleton& target);

struct TargetFinger {
  uint32_t finger = 0;                           // 0 thumb, 1 index, 2 middle, 3 ring, 4 pinky
  std::vector<uint32_t> joints;                  // of the character, from the palm outward: 1 to 3
  std::vector<std::array<double, 3>> positions;  // of these
  std::optional<std::array<double, 3>> end;      // of the last bone
};

struct TargetHand {
  uint32_t joint = 0;  // of the character: the wrist
  int elbow = -1;      // joint above the wrist at another position, -1 without one
  bool right = false;
  bool clear = true;                  // false: joints that move several fingers at once, or fewer than three fingers
  std::vector<TargetFinger> fingers;  // by finger; none: a hand whose fingers its maker did not rig
  double length = 0;                  // from the wrist to the farthest of what it moves (98 % quantile)
};

// Every joint of class hand that moves something, outermost where one hangs on another. Joints of a finger that move
// nothing are left out, and metacarpals, but for the thumb's, are part of the palm. Throws Error where
// target_skeleton() does.
std::vector<TargetHand> target_hands(const Character& character);

// A body's target with the fingers of its clear hands behind it, their bone ends last: "full" bodies for the eye.
TargetSkeleton with_fingers(const Character& character, TargetSkeleton body);

}  // namespace sinew
#endif
