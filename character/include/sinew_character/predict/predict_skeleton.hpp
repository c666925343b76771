// SPDX-License-Identifier: MIT
// A skeleton for a bare mesh, through sinew/rig.h.
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

// What sinew_rig_options says.
struct SkeletonOptions {
  uint32_t method = SINEW_RIG_VOTES;         // sinew_rig_method
  const sinew_model* model = nullptr;        // of sinew_rig_model_open(); not needed for SINEW_RIG_SHAPE
  uint32_t category = 0;                     // sinew_category, of SINEW_RIG_VOTES and SINEW_RIG_SLOTS
  Axis up_axis = Axis::kY;                   // where up is not found
  const sinew_model* front_model = nullptr;  // finds the front; null: by the votes
  bool find_up = false;                      // with front_model: y or z
  uint32_t front = SINEW_FRONT_AUTO;
  bool axes_known = false;  // the file says that y is up and +z front
  uint32_t mirror = SINEW_MIRROR_AUTO;
  uint32_t spine_count = 0;  // 0 = as the model says
  bool toes = true, ends = true;
  uint32_t kernel = SINEW_KERNEL_AUTO;  // AUTO asks kernel_from_environment()
};

struct PredictedSkeleton {
  std::vector<Joint> joints;                         // parents first; bone ends have deforms = false, all others true
  std::vector<uint8_t> classes, ends;                // [J] sinew_joint_class; 1 for a bone end
  std::vector<int32_t> partners;                     // [J] mirror image or -1
  std::vector<float> confidence, parent_confidence;  // [J] 0..1
  bool mirrored = false;
  uint32_t facing = 0;  // where it faces, see sinew_rig_outputs
  std::array<float, 3> front = {0, 0, 1};
  Axis up_axis = Axis::kY;
  float front_confidence = 0, up_confidence = 0;
  float plane = 0, spread = 0;         // see sinew_rig_outputs
  std::optional<float> usable;         // of votes: usable_probability()
  std::vector<uint32_t> rigid_joints;  // [V of the mesh] the joint that moves each solid part; empty: bodies that bend
  std::vector<uint8_t> scenery;        // [V of the mesh] 1 for what the body stands on or before; empty: all is body
  size_t workspace_bytes = 0;
  double seconds = 0;  // in sinew_rig()
};

// A skeleton that stands in place of another one stands as that does, and what both cost is told together.
void take_the_place_of(const PredictedSkeleton& other, PredictedSkeleton* skeleton);

// How likely votes of that spread (PredictedSkeleton::spread) make a skeleton that can be used as it is or mended, 0..1:
// logistic, fitted on 151 samples of families that the votes were not trained on (trainer/configs/RESULTS.md).
float usable_probability(float spread, bool mirrored);
// Below it the user is told.
constexpr float kDoubtfulUsable = 0.4f;
// PredictedSkeleton::spread is the votes' own idea of how far off they are. Above this the mesh is no body (trainer/configs/RESULTS.md).
constexpr float kNoBodySpread = 0.25f;

// Below it a front or an up axis that was found is a coin toss, and the user is told so.
constexpr float kCoinToss = 0.7f;

// The same of SINEW_RIG_SLOTS, whose spread says less: six of forty training characters lie above it.
constexpr float kDoubtfulSlots = 0.05f;

// The character's own joints are not looked at. Throws Error with the character's name, and OutOfMemory.
PredictedSkeleton predict_skeleton(const Character& character, const SkeletonOptions& options);

// Which limbs of a predicted skeleton may be wrong, by what its votes say of themselves.
struct LimbDoubt {
  std::vector<int> joints;  // from the body outwards, bone ends too
  int joint = 0;            // that it is called by
  std::string name;         // of that: LeftArm, RightUpLeg, Tail
  float doubt = 0;          // how likely it is wrong, 0..1
};

// Limbs of a skeleton that was predicted by votes: what hangs on its trunk, in the order of kinds. A limb is wrong whose
// joints are 5 % of the longest side off in the mean, or one of them 10 %: logistic, of how sure the votes are of its joints'
// positions and of the spread of all, fitted on families that the votes were not trained on (trainer/configs/RESULTS.md).
std::vector<LimbDoubt> limb_doubts(const PredictedSkeleton& skeleton);

// From here on the user is told.
constexpr float kDoubtfulLimb = 0.4f;
// The limbs above that, most doubtful first.
std::vector<LimbDoubt> doubtful_limbs(const PredictedSkeleton& skeleton);
// One line, a warning; empty without any.
std::string doubts_text(const std::vector<LimbDoubt>& limbs);

}  // namespace sinew
#endif
