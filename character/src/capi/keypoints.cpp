// SPDX-License-Identifier: MIT
// Keypoints of a person's joints, in frames that are there and in those that come.
#include <array>

#include "handle.hpp"

namespace sinew {
namespace {

std::vector<Point3> keypoints_row(const float* keypoints, size_t count) {
  std::vector<Point3> row;
  for (size_t i = 0; i < count; ++i, keypoints += 3)
    row.push_back(
        {static_cast<double>(keypoints[0]), static_cast<double>(keypoints[1]), static_cast<double>(keypoints[2])});
  return row;
}

template <size_t N>
void put_values(const std::vector<std::array<double, N>>& from, float* to) {
  for (const std::array<double, N>& one : from)
    for (const double value : one) *to++ = static_cast<float>(value);
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" {

sinew_status sinew_character_open_keypoints(const char* layout, const float* keypoints, uint32_t keypoint_count,
                                            uint32_t frame_count, sinew_character** character) {
  return guarded(nullptr, [&] {
    need(layout != nullptr, "layout");
    need(keypoints != nullptr, "keypoints");
    need(character != nullptr, "character");
    std::vector<std::vector<Point3>> rows;
    for (size_t f = 0; f < frame_count; ++f)
      rows.push_back(keypoints_row(keypoints + 3 * keypoint_count * f, keypoint_count));
    auto made = std::make_unique<sinew_character>();
    const auto stream = std::make_shared<const KeypointsStream>(layout, rows);
    made->character.name = layout;
    made->character.joints = rest_joints(stream->person());
    made->character.notes = stream->person().notes;
    made->clips = stream->person().clips;
    made->keypoints = stream;
    made->same_skin = false;
    *character = made.release();
  });
}

sinew_status sinew_character_keypoints_frame(const sinew_character* character, const float* keypoints,
                                             uint32_t keypoint_count, float* rotations, float* translations) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(keypoints != nullptr, "keypoints");
    need(rotations != nullptr && translations != nullptr, "rotations, translations");
    if (character->keypoints == nullptr)
      throw Failure(
          SINEW_ERROR_ARGUMENT,
          "keypoints: the character is not made from keypoints; make one with sinew_character_open_keypoints()");
    const MotionFrame frame = character->keypoints->next(keypoints_row(keypoints, keypoint_count));
    put_values(frame.rotations, rotations);
    put_values(frame.translations, translations);
  });
}

}  // extern "C"
