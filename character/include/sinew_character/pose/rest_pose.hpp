// SPDX-License-Identifier: MIT
// Changes the rest pose of a bound character: arms out and legs down, or the pose of another file's skeleton.
#ifndef SINEW_CHARACTER_REST_POSE_HPP
#define SINEW_CHARACTER_REST_POSE_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Directions of bones.
struct RestPose {
  enum class Kind : uint8_t {
    kT,    // arms along the line of the shoulders, legs down
    kA,    // the same with arms 45 degrees lower
    kLike  // each limb like the matching limb in `like`
  };
  Kind kind = Kind::kT;
  LabeledSkeleton like;
  std::string name;        // name given by the user, for messages
  bool preferred = false;  // a character that cannot be put into it keeps its pose, with a note
};

// Parses "t", "a", or a file with a skeleton. Throws Error.
RestPose read_rest_pose(const std::string& text);

// Returns skinning matrices [J], rest to posed, that bring a skeleton into the pose. Bones of arms and legs rotate
// along the shortest arc, feet keep their slope and point to the front, a torso that leans by more than 10 degrees is
// set upright, and other joints follow their parents; hips keep their position. With kLike, limbs without a match
// follow their parent. Throws Error if names do not give sides, or if kT or kA find no arms: four-legged characters
// need a file.
std::vector<Affine> rest_pose_palette(const LabeledSkeleton& skeleton, const RestPose& pose, Axis up_axis);

// Puts a character into the pose. The mesh follows by the volume-preserving deformation; weights and the height of
// the lowest vertex are unchanged, and a glTF document keeps its materials, normals and shapes. Throws Error for a
// character without weights, and for one that cannot be put into the pose unless it is only preferred.
Character in_rest_pose(const Character& character, const RestPose& pose, Axis up_axis);

}  // namespace sinew
#endif
