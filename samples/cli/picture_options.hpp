// SPDX-License-Identifier: MIT
// Options of commands that take a picture where they take a mesh.
#ifndef SINEW_CLI_PICTURE_OPTIONS_HPP
#define SINEW_CLI_PICTURE_OPTIONS_HPP

#include <nlohmann/json.hpp>
#include <string>

#include "sinew_character/picture/picture_job.hpp"

namespace CLI {
class App;
}

namespace sinew::cli {

constexpr const char* kClassMeaning =
    "What kind of body it is, where it is taken for another: which limbs are arms, legs, wings";

struct PictureOptions {
  std::string mask, mask_out, units = "figure", body;
  uint32_t figure = 0;
  bool flat = false, cut = false;
};
// Of --cut, which a command may have for meshes as well.
constexpr const char* kPictureCut =
    "Of pictures along lines that are drawn into the figure from its outline, as a guess: a leg before a leg";
// Without --class, which a command may have for meshes as well.
void add_picture_options(CLI::App* sub, PictureOptions* options);
void add_picture_class(CLI::App* sub, PictureOptions* options);
// Throws UsageError for options of pictures where `path` is none. Called before any work.
void check_picture_options(const CLI::App& sub, const std::string& path);
PictureJobOptions picture_job(const PictureOptions& options);
// What was asked for beside the character.
void write_mask(const PictureOptions& options, const PictureCharacter& found);
nlohmann::ordered_json picture_json(const PictureCharacter& found);

}  // namespace sinew::cli
#endif
