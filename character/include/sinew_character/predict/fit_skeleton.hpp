// SPDX-License-Identifier: MIT
// A skeleton of the user's own put where another one is: into a mesh for which a skeleton was predicted.
#ifndef SINEW_CHARACTER_FIT_SKELETON_HPP
#define SINEW_CHARACTER_FIT_SKELETON_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The class of a joint that belongs to its parent: a finger, a part of the face, a twist bone, a control.
constexpr uint8_t kClassDetail = 255;

struct LabeledSkeleton {
  std::vector<Joint> joints;     // any order
  std::vector<uint8_t> classes;  // [J] sinew_joint_class or kClassDetail; a bone end's is its joint's
  std::vector<uint8_t> ends;     // [J] 1 for a bone end
};

struct FitOptions {
  Axis up_axis = Axis::kY;
  bool keep_lengths = false;  // bones are turned and all scaled alike
  std::optional<float>
      floor;  // lowest point of the mesh, for roots on the floor; nullopt: as low below the feet as they were
};

// How a joint came to its position.
enum class FitHow : uint8_t {
  kMatched,  // a joint of the other skeleton is there
  kBetween,  // between two of those, along the other's chain
  kCarried   // with the bone that it hangs on
};

struct FittedSkeleton {
  std::vector<Joint> joints;  // names, parents and order of `mine`, new positions
  std::vector<FitHow> how;    // [J]
  size_t matched = 0;         // joints with kMatched
  size_t matchable = 0;       // joints that are neither details nor bone ends: most of them should match
  double scale = 1;           // of the whole, for people
  bool symmetric = false;     // both skeletons are their own mirror images, and so is the result, exactly
};

// Joints are matched by class and side and in the order of their chains: trunk, arms, legs, tails, wings, ears, hair. A
// chain's joints between two that match lie on the other's chain at the same share of its length, so that chains of any
// counts fit. All others are carried by their bone: turned with it and scaled with its length. A root on the floor stays
// under the pelvis and on the floor. `mine` may be of any size, turned about the up axis by quarters, or have y up where
// the other has z. A skeleton fitted to itself, moved or scaled, stays exactly itself up to rounding.
// Throws Error when `mine` has no joints, forms a cycle, or fewer than two joints match.
FittedSkeleton fit_skeleton(const LabeledSkeleton& mine, const LabeledSkeleton& other, const FitOptions& options);

// By names: joint_verdicts(); controls, slots, fingers and faces are details. Leaves
// called ends or tips are bone ends.
LabeledSkeleton label_skeleton(const std::vector<Joint>& joints);
LabeledSkeleton label_skeleton(const PredictedSkeleton& skeleton);

// A file's skeleton in the place of a predicted one: parents first, partners where it is its own mirror image, confidence
// 1. Throws Error for a skeleton without joints or with a cycle.
PredictedSkeleton skeleton_from_joints(const std::vector<Joint>& joints);

}  // namespace sinew
#endif
