// SPDX-License-Identifier: MIT
// sinew_character_pose(): the job of `sinew pose`.
#include "sinew_character/pose/pose.hpp"

#include <cmath>

#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/jobs/pose_job.hpp"

namespace sinew {
namespace {

std::vector<Affine> by_angles(const Character& character, const double* angles) {
  std::vector<JointRotation> rotations;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    JointRotation rotation;
    rotation.joint = j;
    rotation.x = angles[3 * j];
    rotation.y = angles[3 * j + 1];
    rotation.z = angles[3 * j + 2];
    if (!std::isfinite(rotation.x + rotation.y + rotation.z))
      throw Failure(SINEW_ERROR_NOT_FINITE,
                    "angles: joint " + character.joints[j].name + " has an angle that is not finite");
    if (rotation.x != 0 || rotation.y != 0 || rotation.z != 0) rotations.push_back(rotation);
  }
  return pose_palette(character, rotations);
}

std::vector<Affine> by_rotations(const Character& character, const double* rotations) {
  const Motion motion = motion_of(character.joints);
  MotionFrame frame;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    const double* q = rotations + 4 * j;
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!std::isfinite(length) || !(length > 0))
      throw Failure(SINEW_ERROR_NOT_FINITE,
                    "rotations: joint " + character.joints[j].name + " has no rotation of length 1");
    frame.rotations.push_back({q[0] / length, q[1] / length, q[2] / length, q[3] / length});
    frame.translations.push_back(motion.joints[j].offset);
  }
  return motion_palette(motion, frame, character.joints.size());
}

std::vector<Affine> by_matrices(const Character& character, const double* matrices) {
  std::vector<Affine> palette(character.joints.size());
  for (size_t j = 0; j < palette.size(); ++j) {
    std::copy(matrices + 12 * j, matrices + 12 * j + 12, palette[j].begin());
    for (const double value : palette[j])
      if (!std::isfinite(value))
        throw Failure(SINEW_ERROR_NOT_FINITE, "matrices: joint " + character.joints[j].name + " is not finite");
  }
  return palette;
}

std::vector<Affine> by_clip(sinew_character* from, const char* clip, double time) {
  if (!(time >= 0) || !std::isfinite(time)) throw Failure(SINEW_ERROR_ARGUMENT, "time: expected 0 or more");
  const size_t joints = from->character.joints.size();
  if (from->clips.empty()) return clip_palette(own_motion(from), file_of(*from), clip, time, joints, nullptr);
  Motion added = motion_of(from->character.joints);
  added.clips = from->clips;
  return clip_palette(added, file_of(*from), clip, time, joints, nullptr);
}

void pose(const sinew_character_pose_options& options, sinew_character* from, sinew_character** posed) {
  const Character& character = from->character;
  if (character.vertices.empty() || character.joints.empty() || character.influences.empty())
    throw Error(file_of(*from) + ": has no skin weights to pose; bind it first");
  const int said = (options.angles != nullptr ? 1 : 0) + (options.rotations != nullptr ? 1 : 0) +
                   (options.matrices != nullptr ? 1 : 0) + (options.clip != nullptr ? 1 : 0);
  if (said != 1) throw Failure(SINEW_ERROR_ARGUMENT, "pose: expected one of angles, rotations, matrices and clip");
  const auto corrections = corrections_of(options.deform);
  const std::vector<Affine> palette = options.angles != nullptr      ? by_angles(character, options.angles)
                                      : options.rotations != nullptr ? by_rotations(character, options.rotations)
                                      : options.matrices != nullptr  ? by_matrices(character, options.matrices)
                                                                     : by_clip(from, options.clip, options.time);
  const bool dual_quaternion = options_of(options.deform).method == SINEW_POSE_DUAL_QUATERNION;
  PosedCharacter done = pose_character(character, palette, corrections, dual_quaternion);
  if (!done.corrected)
    done.character.notes.push_back(
        "warning: skinning matrices with shear or unequal scales; the pose is linear skinning, without volume "
        "correction. Use rotations with one scale");
  auto out = std::make_unique<sinew_character>();
  out->character = std::move(done.character);
  out->own_skeleton = from->own_skeleton;
  out->same_skin = false;
  out->posed = true;
  *posed = out.release();
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_pose(sinew_character* character, const sinew_character_pose_options* given,
                                             sinew_character** posed) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(posed != nullptr, "posed");
    pose(options_of(given), character, posed);
  });
}
