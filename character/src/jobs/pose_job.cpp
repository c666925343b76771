// SPDX-License-Identifier: MIT
// Poses from clips; skinned and corrected meshes.
#include "sinew_character/jobs/pose_job.hpp"

#include "sinew_character/pose/deform.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {

std::vector<Affine> clip_palette(const Motion& motion, const std::string& file, const std::string& name, double time,
                                 size_t joint_count, std::string* what) {
  const Clip& clip = find_clip(motion, file, name);
  const double seconds = static_cast<double>(clip.frames.size() - 1) * clip.frame_time;
  if (time > seconds + 1e-6)
    throw Error(file + print(": --time %g is after the end of the animation, which lasts %g seconds", time, seconds));
  if (what != nullptr) *what = print("%s at %g of %g seconds", clip.name.c_str(), time, seconds);
  return motion_palette(motion, frame_at(clip, time), joint_count);
}

PosedCharacter pose_character(const Character& character, const std::vector<Affine>& palette,
                              const std::optional<sinew_deform_options>& correction, bool dual_quaternion) {
  if (!correction) return {apply_pose(character, palette, dual_quaternion), true};
  CharacterDeformer deformer(character, *correction);
  PosedCharacter posed;
  posed.character = deformer.pose_character(character, palette);
  posed.corrected = deformer.corrected();
  return posed;
}

}  // namespace sinew
