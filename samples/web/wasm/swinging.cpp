// SPDX-License-Identifier: MIT
// Clips that the page plays have their springs as files have them; a drag is played live.
#include "swinging.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "capi/handle.hpp"
#include "sinew_character/springs/play_springs.hpp"

namespace sinew::web {
namespace {

constexpr int kStepsBefore = 60;    // that chains have swung when a drag begins
constexpr double kStep = 1.0 / 60;  // seconds
constexpr double kRadians = std::numbers::pi / 180;

}  // namespace

void swing(sinew_character* handle) {
  Motion motion = motion_of(handle->character.joints);
  motion.name = handle->character.name;
  for (Clip& clip : handle->clips) (void)play_springs(*handle->springs, motion, &clip);
}

std::unique_ptr<sinew_character> swung(const sinew_character& moving, const sinew_character& springs, uint32_t clip) {
  auto out = std::make_unique<sinew_character>();
  out->character.name = moving.character.name;
  out->character.joints = moving.character.joints;
  out->springs = springs.springs;
  out->clips = {moving.clips.at(clip)};
  swing(out.get());
  return out;
}

MotionFrame turned_frame(const std::vector<Joint>& rest, const float* degrees) {
  MotionFrame frame;
  for (const MotionJoint& joint : motion_of(rest).joints) {
    const float* const turn = degrees + 3 * frame.rotations.size();
    Quaternion rotation = kNoRotation4;
    for (size_t axis = 0; axis < 3; ++axis)
      rotation = multiply(axis_rotation(axis, static_cast<double>(turn[axis]) * kRadians), rotation);
    frame.rotations.push_back(rotation);
    frame.translations.push_back(joint.offset);
  }
  return frame;
}

LiveSprings::LiveSprings(const Springs& springs, const std::vector<Joint>& rest, size_t up_axis,
                         const std::function<MotionFrame(double)>& pose_at, double seconds)
    : motion_(motion_of(rest)), up_axis_(up_axis), springs_(springs, motion_) {
  for (size_t j = 0; j < rest.size(); ++j)
    if (rest[j].parent < 0) roots_.push_back(j);
  for (int step = kStepsBefore; step >= 0; --step) {
    const double at = std::max(0.0, seconds - step * kStep);
    (void)palette(pose_at(at), at, kStep, {});
  }
}

std::vector<Affine> LiveSprings::palette(MotionFrame pose, double seconds, double passed, const Drag& drag) {
  const Point3 root = pose.translations[roots_.front()];
  if (seconds < last_seconds_) carried_ = carried_ + last_root_ - root;
  last_seconds_ = seconds;
  last_root_ = root;
  const Quaternion turn = axis_rotation(up_axis_, drag.degrees * kRadians);
  for (const size_t j : roots_) {
    pose.rotations[j] = multiply(turn, pose.rotations[j]);
    pose.translations[j] = root + rotate(turn, pose.translations[j] - root) + drag.move;
  }
  MotionFrame swinging = pose;
  for (const size_t j : roots_) swinging.translations[j] = swinging.translations[j] + carried_;
  springs_.frame(passed, &swinging);
  pose.rotations = std::move(swinging.rotations);
  return motion_palette(motion_, pose, motion_.joints.size());
}

}  // namespace sinew::web
