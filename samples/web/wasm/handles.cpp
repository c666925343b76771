// SPDX-License-Identifier: MIT
// Handles are copies: what a job does to one, the session does not see.
#include "handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "capi/handle.hpp"
#include "characters.hpp"
#include "sinew_character/pose/character_transform.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew::web {

using Json = nlohmann::json;

namespace {

// What the joints that move something take up: in a clip, in a clip around the middle of all joints, and at rest. Cameras and targets of
// inverse kinematics, which move nothing, may be far away.
//   moves  [joints] as follows_of() gives it: empty if no weights are known
Json room_json(const Motion& motion, const Clip& clip, const std::vector<Joint>& rest,
               const std::vector<uint8_t>& moves) {
  std::array<std::array<double, 2>, 3> is, around, at_rest;
  is.fill({1e30, -1e30});
  around = at_rest = is;
  const auto grow = [](std::array<double, 2>& side, double x) { side = {std::min(side[0], x), std::max(side[1], x)}; };
  const auto counts = [&](size_t j) { return moves.empty() || moves[j] != SINEW_FOLLOWS_NONE; };
  for (size_t j = 0; j < rest.size(); ++j)
    for (size_t i = 0; i < 3 && counts(j); ++i) grow(at_rest[i], point(rest[j].position)[i]);
  for (const MotionFrame& frame : clip.frames) {
    const std::vector<Affine> palette = motion_palette(motion, frame, rest.size());
    std::vector<std::array<double, 3>> positions;
    std::array<double, 3> middle = {0, 0, 0};
    for (size_t j = 0; j < rest.size(); ++j) {
      const Vec3& p = rest[j].position;
      const auto at = transform_point(palette[j], p.x, p.y, p.z);
      positions.push_back({at[0], at[1], at[2]});
      for (size_t i = 0; i < 3; ++i) middle[i] += at[i] / static_cast<double>(rest.size());
    }
    for (size_t j = 0; j < rest.size(); ++j)
      for (size_t i = 0; i < 3 && counts(j); ++i) {
        grow(is[i], positions[j][i]);
        grow(around[i], positions[j][i] - middle[i]);
      }
  }
  return {{"is", is}, {"around", around}, {"rest", at_rest}};
}

}  // namespace

std::unique_ptr<sinew_character> handle_of(const Session& s, CopyOf what, const sinew_character* moving) {
  need_weights(s);
  auto handle = std::make_unique<sinew_character>();
  handle->character = what == CopyOf::kWritten ? written(s) : s.character;
  if (what == CopyOf::kFile && s.standing) handle->character.joints = s.standing->joints;
  handle->picture = s.picture();
  handle->same_skin = false;
  if (moving != nullptr && are_alike(moving->character.joints, s.character.joints)) handle->clips = moving->clips;
  return handle;
}

double put_on_floor(sinew_character* handle, Axis up_axis) {
  constexpr double kStands = 0.02;
  const size_t up = axis_index(up_axis);
  const Box box = box_of(handle->character.vertices);
  const double low = point(box.low)[up], high = point(box.high)[up];
  if (handle->picture != nullptr || std::abs(low) <= kStands * (high - low)) return 0;
  handle->character = transformed(std::move(handle->character), {{}, 0, true}, up_axis);
  for (Clip& clip : handle->clips)
    for (MotionFrame& frame : clip.frames)
      for (size_t j = 0; j < handle->character.joints.size(); ++j)
        if (handle->character.joints[j].parent < 0) frame.translations[j][up] -= low;
  return low;
}

Json clips_json(const sinew_character& moving) {
  const std::vector<Joint>& rest = moving.character.joints;
  const Motion motion = motion_of(rest);
  const std::vector<uint8_t> moves = follows_of(moving.character);
  Json list = Json::array();
  for (const Clip& clip : moving.clips)
    list.push_back({{"name", clip.name},
                    {"frames", clip.frames.size()},
                    {"seconds", static_cast<double>(clip.frames.size() - 1) * clip.frame_time},
                    {"room", room_json(motion, clip, rest, moves)}});
  return list;
}

MotionFrame frame_of(const Session& s, const sinew_character* moving, uint32_t clip, double seconds) {
  need_weights(s);
  if (moving == nullptr || clip >= moving->clips.size() || !are_alike(moving->character.joints, s.character.joints))
    throw Error("no motion is open");
  return frame_at(moving->clips[clip], seconds);
}

std::vector<Affine> palette_at(const Session& s, const sinew_character* moving, uint32_t clip, double seconds) {
  const MotionFrame frame = frame_of(s, moving, clip, seconds);
  const std::vector<Joint>& rest = moving->character.joints;
  return motion_palette(motion_of(rest), frame, rest.size());
}

}  // namespace sinew::web
