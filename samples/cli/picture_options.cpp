// SPDX-License-Identifier: MIT
// --mask, --mask-out, --figure, --flat, --units and --class.
#include "picture_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "options.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {

void add_picture_options(CLI::App* sub, PictureOptions* options) {
  section(sub, "Pictures");
  sub->add_option("--mask", options->mask, "A picture that is bright where the figure is. Found unless given")
      ->type_name("FILE");
  sub->add_option("--mask-out", options->mask_out, "The figure that was found, white on black")->type_name("FILE.png");
  sub->add_option("--figure", options->figure, "Of several figures, from left to right. The largest unless given")
      ->check(CLI::Range(1u, 99u))
      ->type_name("N");
  sub->add_option("--units", options->units,
                  "figure: its longest side is 1; pixels: places are the picture's, x right, y up from the bottom edge")
      ->check(CLI::IsMember({"figure", "pixels"}))
      ->capture_default_str();
  sub->add_flag("--flat", options->flat, "A card instead of a body as thick as it is wide");
}

void add_picture_class(CLI::App* sub, PictureOptions* options) {
  sub->add_option("--class", options->body, std::string(kClassMeaning) + ". Found unless given")
      ->type_name("KIND")
      ->check(CLI::IsMember(body_class_words()));
}

void check_picture_options(const CLI::App& sub, const std::string& path) {
  if (is_picture(path)) return;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    for (const char* option : {"--mask", "--mask-out", "--figure"})
      if (sub.get_option(option)->count() > 0)
        throw UsageError(std::string(option) + " is for one picture, and " + path + " is a folder");
    return;
  }
  for (const char* option : {"--mask", "--mask-out", "--figure", "--units", "--flat"})
    if (sub.get_option(option)->count() > 0)
      throw UsageError(std::string(option) + " is for pictures (" + picture_files() + "), and " + path + " is none");
}

PictureJobOptions picture_job(const PictureOptions& options) {
  PictureJobOptions job;
  job.mask = options.mask;
  job.figure.number = options.figure;
  job.figure.cut = options.cut;
  job.mesh.pixels = options.units == "pixels";
  job.mesh.flat = options.flat;
  if (!options.body.empty()) job.body = body_class_of(options.body);
  if (!options.mask_out.empty()) check_output(options.mask_out, {".png"});
  return job;
}

void write_mask(const PictureOptions& options, const PictureCharacter& found) {
  if (options.mask_out.empty()) return;
  const Mask mask = full_mask(*found.picture, found.figure);
  Image image;
  image.width = static_cast<int>(mask.width);
  image.height = static_cast<int>(mask.height);
  for (const uint8_t inside : mask.inside)
    image.rgb.insert(image.rgb.end(), 3, inside != 0 ? uint8_t{255} : uint8_t{0});
  write_file(options.mask_out, encode_png(image));
}

nlohmann::ordered_json picture_json(const PictureCharacter& found) {
  return {{"class", body_class_word(found.body)},
          {"view", picture_view_text(found.view)},
          {"certainty", found.certainty},
          {"figures", found.figure.count},
          {"figure", found.figure.number}};
}

}  // namespace sinew::cli
