// SPDX-License-Identifier: MIT
// A predicted skeleton as the arrays that sinew_rig_details() takes and lets grow.
#ifndef SINEW_CHARACTER_PREDICT_SKELETON_ARRAYS_HPP
#define SINEW_CHARACTER_PREDICT_SKELETON_ARRAYS_HPP

#include <string>
#include <vector>

#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

class SkeletonArrays {
 public:
  // Throws Error when the skeleton has more joints than there is room for.
  //   names  whether the engine sees the joints' names, as far as they fit; else it gives those behind a joint's own
  SkeletonArrays(const Character& character, const PredictedSkeleton& skeleton, const std::string& what, bool names);
  SkeletonArrays(const SkeletonArrays&) = delete;
  SkeletonArrays& operator=(const SkeletonArrays&) = delete;

  // Adds one sinew_rig_detail; hands_model is for hands alone. Throws Error and OutOfMemory with the character's name. The
  // skeleton's seconds and workspace grow; its joints are as they were.
  void grow(const Character& character, const SkeletonOptions& options, sinew_rig_detail detail,
            const sinew_model* hands_model, PredictedSkeleton* skeleton);

  size_t joint_count() const { return outputs_.joint_count; }
  int parent(size_t j) const { return parents_[j]; }
  uint8_t joint_class(size_t j) const { return classes_[j]; }
  const char* name(size_t j) const { return &names_[j * SINEW_JOINT_NAME_BYTES]; }
  // Makes the skeleton's arrays as long as these, with everything but joints and ends.
  void resize(PredictedSkeleton* skeleton) const;
  // Writes joint j, of this name.
  void take(size_t j, const std::string& name, PredictedSkeleton* skeleton) const;

 private:
  std::vector<float> positions_;
  std::vector<int32_t> parents_, partners_;
  std::vector<uint8_t> flags_, classes_;
  std::vector<uint16_t> confidence_, parent_confidence_;
  std::vector<char> names_;
  sinew_rig_outputs outputs_;
};

}  // namespace sinew
#endif
