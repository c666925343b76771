// SPDX-License-Identifier: MIT
// Fits the user's own skeleton to another one, usually the predicted skeleton of a mesh.
#ifndef SINEW_CHARACTER_FIT_SKELETON_HPP
#define SINEW_CHARACTER_FIT_SKELETON_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Class of a joint that is a detail of its parent: a finger, a part of the face, a twist bone, a control.
constexpr uint8_t kClassDetail = 255;

struct LabeledSkeleton {
  std::vector<Joint> joints;     // any order
  std::vector<uint8_t> classes;  // [J] sinew_joint_class or kClassDetail; a bone end's is its joint's
  std::vector<uint8_t> ends;     // [J] 1 for a bone end
};

struct FitOptions {
  Axis up_axis = Axis::kY;
  bool keep_lengths = false;  // bones are rotated and all scaled by one factor
  std::optional<float>
      floor;  // lowest point of the mesh, for roots on the floor; nullopt: unchanged distance below the feet
};

// How the position of a joint was found.
enum class FitHow : uint8_t {
  kMatched,  // position of a joint of the other skeleton
  kBetween,  // between two of those, along the chain of the other skeleton
  kCarried   // moved with its parent bone
};

struct FittedSkeleton {
  std::vector<Joint> joints;  // names, parents and order of `mine`, new positions
  std::vector<FitHow> how;    // [J]
  size_t matched = 0;         // joints with kMatched
  size_t matchable = 0;       // joints that are neither details nor bone ends: most of them should match
  double scale = 1;           // of the whole, for reports
  bool symmetric = false;     // both skeletons and the result are symmetric, exactly
};

// Joints are matched by class and side in the order of their chains: torso, arms, legs, tails, wings, ears, hair.
// Joints between two matched ones are placed on the other's chain at the same share of its length, so that chains may
// have any number of joints. All other joints follow their bone: rotated with it and scaled with its length. A root
// on the floor stays under the pelvis and on the floor. `mine` may have any size, any rotation by multiples of 90
// degrees about the up axis, or y up where the other has z up. A skeleton fitted to itself, moved or scaled, is
// unchanged up to rounding. Throws Error if `mine` has no joints or a cycle, or if fewer than two joints match.
FittedSkeleton fit_skeleton(const LabeledSkeleton& mine, const LabeledSkeleton& other, const FitOptions& options);

// Classifies joints by joint_verdicts(); controls, slots, fingers and faces are details. Leaves called ends or tips
// are bone ends.
LabeledSkeleton label_skeleton(const std::vector<Joint>& joints);
LabeledSkeleton label_skeleton(const PredictedSkeleton& skeleton);

// Converts a file's skeleton to the form of a predicted one: parents first, partners if it is symmetric, confidence
// 1. Throws Error for a skeleton without joints or with a cycle.
PredictedSkeleton skeleton_from_joints(const std::vector<Joint>& joints);

}  // namespace sinew
#endif
