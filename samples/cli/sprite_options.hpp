// SPDX-License-Identifier: MIT
// --sprites and --loop of animate: an animated picture as frames.
#ifndef SINEW_CLI_SPRITE_OPTIONS_HPP
#define SINEW_CLI_SPRITE_OPTIONS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/picture/sprites.hpp"
#include "sinew_formats/io.hpp"

namespace CLI {
class App;
}

namespace sinew::cli {

struct SpriteSettings {
  uint32_t count = 0;  // frames a clip; 0: no sheet
  std::string loop;
};
inline bool wants_sprites(const SpriteSettings& settings) { return settings.count > 0 || !settings.loop.empty(); }
void add_sprite_options(CLI::App* sub, SpriteSettings* settings);
// Throws UsageError for them where `path` is no picture. Called before any work.
void check_sprite_options(const SpriteSettings& settings, const std::string& path);
// What was asked for, to be written beside `output`: NAME.sprites.png with NAME.sprites.json, the loop.
std::vector<NamedBytes> sprite_files(const SpriteSettings& settings, const std::string& output,
                                     const PictureFile& picture, const Character& character, const Motion& motion,
                                     CharacterDeformer* deformer);

}  // namespace sinew::cli
#endif
