// SPDX-License-Identifier: MIT
// A skeleton's arrays go through sinew_rig_details(); longer ones come back.
#include "sinew_character/predict/predict_face.hpp"

#include "skeleton_arrays.hpp"

namespace sinew {

namespace {

// Lets the skeleton grow by one detail and returns how many joints there are more that are no bone ends.
size_t add_joints(const Character& character, const SkeletonOptions& options, const char* what, sinew_rig_detail detail,
                  PredictedSkeleton* skeleton) {
  const size_t before = skeleton->joints.size();
  SkeletonArrays arrays(character, *skeleton, what, true);
  arrays.grow(character, options, detail, nullptr, skeleton);
  size_t more = 0;
  arrays.resize(skeleton);
  for (size_t j = before; j < arrays.joint_count(); ++j) {
    arrays.take(j, arrays.name(j), skeleton);
    more += skeleton->ends[j] == 0 ? 1 : 0;
  }
  return more;
}

}  // namespace

size_t predict_face(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "faces", SINEW_DETAIL_FACE, skeleton);
}

size_t predict_props(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "props", SINEW_DETAIL_PROPS, skeleton);
}

}  // namespace sinew
