// SPDX-License-Identifier: MIT
// The skeleton that a rigged character teaches and that a predicted one is measured by: the joints that move its body,
// whatever else its maker put into the file.
#ifndef SINEW_DATA_SETS_TARGET_SKELETON_HPP
#define SINEW_DATA_SETS_TARGET_SKELETON_HPP

#include <array>
#include <cstdint>
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
//    0.85 of the way to the end (98 % quantile) of its vertices, in their mean direction. None where that is below 1 %.
// Throws Error for a character without joints, weights or extent, or with indices that lead nowhere.
TargetSkeleton target_skeleton(const Character& character);

// As joints of a file, in the same order. Names are unique, and no leaf but a bone end is named as one.
std::vector<Joint> target_joints(const TargetSkeleton& target);

}  // namespace sinew
#endif
