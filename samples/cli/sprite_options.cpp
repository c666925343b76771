// SPDX-License-Identifier: MIT
// Frames of an animated picture: a sheet for 2D engines, a loop that browsers play.
#include "sprite_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "sinew_character/picture/picture_job.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

constexpr uint32_t kSpriteSide = 256;  // pixels

}  // namespace

void add_sprite_options(CLI::App* sub, SpriteSettings* settings) {
  sub->add_option("--sprites", settings->count,
                  "A sheet of so many frames a clip for 2D engines, NAME.sprites.png with NAME.sprites.json beside the "
                  "output (a JSON hash as of TexturePacker and Aseprite)")
      ->check(CLI::Range(1u, 512u))
      ->type_name("N");
  sub->add_option("--loop", settings->loop, "The clips as an animated PNG that plays for ever")->type_name("FILE.png");
}

void check_sprite_options(const SpriteSettings& settings, const std::string& path) {
  if (!settings.loop.empty()) check_output(settings.loop, {".png", ".apng"});
  if (is_picture(path)) return;
  if (settings.count > 0) throw UsageError("--sprites is for pictures, and " + path + " is none");
  if (!settings.loop.empty()) throw UsageError("--loop is for pictures, and " + path + " is none");
}

std::vector<NamedBytes> sprite_files(const SpriteSettings& settings, const std::string& output,
                                     const PictureFile& picture, const Character& character, const Motion& motion,
                                     CharacterDeformer* deformer) {
  std::vector<NamedBytes> files;
  if (settings.count > 0) {
    FrameOptions options;
    options.count = settings.count;
    options.side = kSpriteSide;
    const std::string name = (std::filesystem::path(output).parent_path() / (stem_of(output) + ".sprites")).string();
    const SpriteSheet sheet = sprite_sheet(picture_frames(picture, character, motion, deformer, options),
                                           std::filesystem::path(name + ".png").filename().string());
    files.push_back({name + ".png", encode_png(sheet.pixels)});
    files.push_back({name + ".json", {sheet.json.begin(), sheet.json.end()}});
  }
  if (!settings.loop.empty())
    files.push_back({settings.loop, encode_loop(picture_frames(picture, character, motion, deformer, {}))});
  return files;
}

}  // namespace sinew::cli
