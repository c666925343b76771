// SPDX-License-Identifier: MIT
// Predicts a skeleton for a bare mesh by sinew/rig.h.
#ifndef SINEW_CHARACTER_PREDICT_SKELETON_HPP
#define SINEW_CHARACTER_PREDICT_SKELETON_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Options as in sinew_rig_options.
struct SkeletonOptions {
  uint32_t method = SINEW_RIG_VOTES;         // sinew_rig_method
  const sinew_model* model = nullptr;        // of sinew_rig_model_open(); not needed for SINEW_RIG_SHAPE
  uint32_t category = 0;                     // sinew_category, of SINEW_RIG_VOTES and SINEW_RIG_SLOTS
  Axis up_axis = Axis::kY;                   // used if find_up is false
  const sinew_model* front_model = nullptr;  // finds the front; null: by the votes
  bool find_up = false;                      // with front_model: y or z
  uint32_t front = SINEW_FRONT_AUTO;
  bool axes_known = false;  // the file format has y up and +z front
  uint32_t mirror = SINEW_MIRROR_AUTO;
  uint32_t spine_count = 0;  // 0 = as predicted
  bool toes = true, ends = true;
  uint32_t kernel = SINEW_KERNEL_AUTO;  // AUTO uses kernel_from_environment()
};

struct PredictedSkeleton {
  std::vector<Joint> joints;                         // parents first; bone ends have deforms = false, all others true
  std::vector<uint8_t> classes, ends;                // [J] sinew_joint_class; 1 for a bone end
  std::vector<int32_t> partners;                     // [J] mirror image or -1
  std::vector<float> confidence, parent_confidence;  // [J] 0..1
  bool mirrored = false;
  uint32_t facing = 0;  // front direction, see sinew_rig_outputs
  std::array<float, 3> front = {0, 0, 1};
  Axis up_axis = Axis::kY;
  float front_confidence = 0, up_confidence = 0;
  float plane = 0, spread = 0;         // see sinew_rig_outputs
  std::optional<float> usable;         // for votes: usable_probability()
  std::vector<uint32_t> rigid_joints;  // [V of the mesh] joint of each solid part; empty for bodies that bend
  std::vector<uint8_t> scenery;        // [V of the mesh] 1: scenery below or behind the body; empty: none
  size_t workspace_bytes = 0;
  double seconds = 0;  // duration of sinew_rig()
};

// Replaces a skeleton by another one in the same orientation, and adds up their durations.
void take_the_place_of(const PredictedSkeleton& other, PredictedSkeleton* skeleton);

// Returns the probability, 0..1, that votes with this spread (PredictedSkeleton::spread) give a skeleton that is
// usable as it is or after edits: logistic, fitted on 151 samples of families outside the training data
// (trainer/configs/RESULTS.md).
float usable_probability(float spread, bool mirrored);
// Below this probability the result carries a warning.
constexpr float kDoubtfulUsable = 0.4f;
// PredictedSkeleton::spread is the votes' estimate of their error. Above this value the mesh is not a body
// (trainer/configs/RESULTS.md).
constexpr float kNoBodySpread = 0.25f;

// Below this confidence the result carries a warning that the front or the up axis is uncertain.
constexpr float kCoinToss = 0.7f;

// The same for SINEW_RIG_SLOTS, whose spread is less reliable: six of forty training characters are above it.
constexpr float kDoubtfulSlots = 0.05f;

// Ignores the character's own joints. Throws Error with the character's name, and OutOfMemory.
PredictedSkeleton predict_skeleton(const Character& character, const SkeletonOptions& options);

// Doubtful limbs of a predicted skeleton, by the confidence of its votes.
struct LimbDoubt {
  std::vector<int> joints;  // from the body outwards, bone ends too
  int joint = 0;            // joint that names the limb
  std::string name;         // its name: LeftArm, RightUpLeg, Tail
  float doubt = 0;          // probability that it is wrong, 0..1
};

// Returns the limbs of a skeleton predicted by votes: the chains on its torso, in the order of kinds. A limb counts
// as wrong if its joints are off by a mean of 5 % of the longest side, or one of them by 10 %. The probability is
// logistic in the confidence of its joints' positions and the spread, fitted on families outside the training data
// (trainer/configs/RESULTS.md).
std::vector<LimbDoubt> limb_doubts(const PredictedSkeleton& skeleton);

// From this doubt on the result carries a warning.
constexpr float kDoubtfulLimb = 0.4f;
// Returns the limbs above that, most doubtful first.
std::vector<LimbDoubt> doubtful_limbs(const PredictedSkeleton& skeleton);
// Returns a warning in one line; empty without doubtful limbs.
std::string doubts_text(const std::vector<LimbDoubt>& limbs);

}  // namespace sinew
#endif
