// SPDX-License-Identifier: MIT
// A bound character put into another rest pose: arms out, legs down, or as the skeleton of another file stands.
#ifndef SINEW_CHARACTER_REST_POSE_HPP
#define SINEW_CHARACTER_REST_POSE_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Where bones shall point.
struct RestPose {
  enum class Kind : uint8_t {
    kT,    // arms along the shoulders' line, legs down
    kA,    // the same with arms 45 degrees lower
    kLike  // every limb as its like in `like`
  };
  Kind kind = Kind::kT;
  LabeledSkeleton like;
  std::string name;  // what the user called it, for messages
};

// "t", "a", or a file with a skeleton. Throws Error.
RestPose read_rest_pose(const std::string& text);

// The turns that bring a skeleton there: skinning matrices [J], rest to posed. Each bone of an arm or leg turns the shortest way, feet keep
// their slope and point to the front, a trunk that leans by more than 10 degrees is put upright, and all else goes with its parent; hips
// stay where they are. Of kLike, limbs without a like go with their parent.
// Throws Error where sides are not told by names, or kT or kA find no arms: four-legged characters have their stance from a file.
std::vector<Affine> rest_pose_palette(const LabeledSkeleton& skeleton, const RestPose& pose, Axis up_axis);

// The mesh follows by the deformation that keeps volume; weights stay, the lowest vertex is as high as it was, and a
// document of glTF keeps its materials, normals and shapes. Throws Error for a character without weights.
Character in_rest_pose(const Character& character, const RestPose& pose, Axis up_axis);

}  // namespace sinew
#endif
