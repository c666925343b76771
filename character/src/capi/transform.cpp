// SPDX-License-Identifier: MIT
// sinew_character_transform(): --turn, --height and --floor of the command.
#include "handle.hpp"
#include "sinew_character/pose/character_transform.hpp"

namespace sinew {
namespace {

void transform_character(const sinew_character_transform_options& options, sinew_character* character) {
  need(options.turns != nullptr || options.turn_count == 0, "turns");
  check_at_most("floor", options.floor, 1);
  CharacterTransform transform;
  for (uint32_t t = 0; t < options.turn_count; ++t) {
    need(options.turns[t] != nullptr, "turns");
    transform.turns.emplace_back(options.turns[t]);
  }
  transform.height = options.height;
  transform.floor = options.floor != 0;
  check_transform(transform);
  const std::string& name = character->character.name;
  if (character->picture != nullptr) throw Error(name + ": is of a picture, which stays in its plane");
  if (!character->clips.empty() || !character->morphs.shapes.empty())
    throw Error(name + ": has clips or morph targets that are in no file yet; transform it before they are added");
  const Axis up_axis = up_axis_of("up", options.up == SINEW_UP_AUTO ? uint32_t{SINEW_UP_Y} : options.up);
  const bool same_skin = character->same_skin;
  character->character = transformed(character->character, transform, up_axis);
  character->own_motion.reset();
  changed(character);
  character->same_skin = same_skin;
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_transform(sinew_character* character,
                                                  const sinew_character_transform_options* given) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    transform_character(options_of(given), character);
  });
}
