// SPDX-License-Identifier: MIT
// Places of a person's joints, in frames that are there and in those that come.
#include <array>

#include "handle.hpp"

namespace sinew {
namespace {

std::vector<Point3> places_row(const float* places, size_t count) {
  std::vector<Point3> row;
  for (size_t i = 0; i < count; ++i, places += 3)
    row.push_back({static_cast<double>(places[0]), static_cast<double>(places[1]), static_cast<double>(places[2])});
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

sinew_status sinew_character_open_places(const char* layout, const float* places, uint32_t place_count,
                                         uint32_t frame_count, sinew_character** character) {
  return guarded(nullptr, [&] {
    need(layout != nullptr, "layout");
    need(places != nullptr, "places");
    need(character != nullptr, "character");
    std::vector<std::vector<Point3>> rows;
    for (size_t f = 0; f < frame_count; ++f) rows.push_back(places_row(places + 3 * place_count * f, place_count));
    auto made = std::make_unique<sinew_character>();
    const auto stream = std::make_shared<const PlacesStream>(layout, rows);
    made->character.name = layout;
    made->character.joints = rest_joints(stream->person());
    made->character.notes = stream->person().notes;
    made->clips = stream->person().clips;
    made->places = stream;
    made->same_skin = false;
    *character = made.release();
  });
}

sinew_status sinew_character_places_frame(const sinew_character* character, const float* places, uint32_t place_count,
                                          float* rotations, float* translations) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(places != nullptr, "places");
    need(rotations != nullptr && translations != nullptr, "rotations, translations");
    if (character->places == nullptr)
      throw Failure(SINEW_ERROR_ARGUMENT, "places: the character is of none; sinew_character_open_places() makes one");
    const MotionFrame frame = character->places->next(places_row(places, place_count));
    put_values(frame.rotations, rotations);
    put_values(frame.translations, translations);
  });
}

}  // extern "C"
