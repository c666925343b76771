// SPDX-License-Identifier: MIT
// A skeleton for a bare mesh, through sinew/rig.h.
#ifndef SINEW_CHARACTER_PREDICT_SKELETON_HPP
#define SINEW_CHARACTER_PREDICT_SKELETON_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/character.hpp"

namespace sinew {

// What sinew_rig_options says.
struct SkeletonOptions {
  uint32_t method = SINEW_RIG_VOTES;   // sinew_rig_method
  const sinew_model* model = nullptr;  // of sinew_rig_model_open(); not needed for SINEW_RIG_SHAPE
  uint32_t category = 0;               // of SINEW_RIG_SLOTS
  uint32_t up_axis = 0;
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
  uint32_t facing = 0;          // where it faces, see sinew_rig_outputs
  float plane = 0, spread = 0;  // see sinew_rig_outputs
  std::optional<float> usable;  // of votes: usable_probability()
  size_t workspace_bytes = 0;
  double seconds = 0;  // in sinew_rig()
};

// How likely votes of that spread (PredictedSkeleton::spread) make a skeleton that can be used as it is or mended, 0..1:
// logistic, fitted on 151 samples of families that the votes were not trained on (trainer/configs/RESULTS.md).
float usable_probability(float spread, bool mirrored);
// Below it the user is told.
constexpr float kDoubtfulUsable = 0.4f;
// PredictedSkeleton::spread, the votes' own idea of how far off they are, says when they know nothing.
// Above it votes are as far off as the mesh's middle line (SINEW_RIG_SHAPE), which claims less: trainer/configs/RESULTS.md.
constexpr float kUnknownSpread = 0.09f;

// The character's own joints are not looked at. Throws Error with the character's name, and OutOfMemory.
PredictedSkeleton predict_skeleton(const Character& character, const SkeletonOptions& options);

}  // namespace sinew
#endif
