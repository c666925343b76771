// SPDX-License-Identifier: MIT
// Groups of options that several commands share: the style of weights, corrections of poses, pictures instead of meshes,
// sprites of animated pictures, what another program wants of a file.
#ifndef SINEW_CLI_OPTION_GROUPS_HPP
#define SINEW_CLI_OPTION_GROUPS_HPP

#include <CLI/CLI.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sinew/deform.h"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/jobs/picture_job.hpp"
#include "sinew_character/picture/sprites.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/io.hpp"

namespace sinew::cli {

struct StyleOptions {
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO;
  double softness = 1;
  uint32_t surface_vertices = 32768;
};
// Under a heading of their own. `style` must live as long as the subcommand.
void add_style_options(CLI::App* sub, StyleOptions* style);
// Throws UsageError when the method of `options` has no use for the softness.
void apply_style(const StyleOptions& style, BindOptions* options);
// " --rigid-parts always --softness 2", without what is as usual: empty for the defaults.
std::string style_text(const StyleOptions& style);

struct DeformSettings {
  std::string method;  // empty: what the command does by itself
  unsigned cells = 0, rounds = 0;
  bool body_contact = false;
  double stiffness = 0;  // 0: the method's own
  uint32_t tet_weights = SINEW_TET_WEIGHTS_SKIN;
  bool no_smoothing = false, as_drawn = false;
};

// The engine's options for volume, xpbd and delta-mush; nullopt for plain skinning. UsageError for the others without one
// of these.
std::optional<sinew_deform_options> deform_options(const DeformSettings& settings);

// Adds --deform with these methods. `what` comes before what they mean.
void add_deform_options(CLI::App* sub, const std::vector<std::string>& methods, const std::string& what,
                        DeformSettings* settings);
// Adds --cells, --rounds, --body-contact and those of xpbd alone under a heading of their own.
void add_solver_options(CLI::App* sub, DeformSettings* settings);
// Adds --as-drawn; `more` is what else it asks of the command.
void add_drawn_correction(CLI::App* sub, DeformSettings* settings, const std::string& more = "");

constexpr const char* kClassMeaning =
    "Body class, where the prediction is wrong. It decides which limbs are arms, legs, wings";

struct PictureOptions {
  std::string mask, mask_out, units = "figure", body;
  uint32_t figure = 0;
  bool flat = false, cut = false, whole = false;
};
// Of --cut, which a command may have for meshes as well.
constexpr const char* kPictureCut =
    "Cut pictures along lines drawn into the figure from its outline, such as one leg in front of the other";
// Without --class, which a command may have for meshes as well.
void add_picture_options(CLI::App* sub, PictureOptions* options);
void add_picture_class(CLI::App* sub, PictureOptions* options);
// Throws UsageError for options of pictures where `path` is none. Called before any work.
void check_picture_options(const CLI::App& sub, const std::string& path);
PictureJobOptions picture_job(const PictureOptions& options);
// Writes the requested outputs beside the character.
void write_mask(const PictureOptions& options, const PictureCharacter& found);
nlohmann::ordered_json picture_json(const PictureCharacter& found);

struct SpriteSettings {
  uint32_t count = 0;  // frames a clip; 0: no sheet
  std::string loop;
};
inline bool wants_sprites(const SpriteSettings& settings) { return settings.count > 0 || !settings.loop.empty(); }
void add_sprite_options(CLI::App* sub, SpriteSettings* settings);
// Throws UsageError for them where `path` is no picture. Called before any work.
void check_sprite_options(const SpriteSettings& settings, const std::string& path);
// Requested files, to be written beside `output`: NAME.sprites.png with NAME.sprites.json, the loop.
std::vector<NamedBytes> sprite_files(const SpriteSettings& settings, const std::string& output,
                                     const PictureFile& picture, const Character& character, const Motion& motion,
                                     CharacterDeformer* deformer);

struct ProfileSettings {
  std::string profile;   // empty: none
  std::string controls;  // file of controls; empty: none
  ProfileOptions options;
};

void add_profile_options(CLI::App* sub, ProfileSettings* settings);
// --controls, of the commands that make or move skeletons.
void add_controls_option(CLI::App* sub, ProfileSettings* settings);
// Before any work: the profile's rest pose where none is asked for, none for "none", and what it needs. Throws UsageError.
//   to_pose  in/out; null where the command keeps the character's
// Returns whether the pose is the profile's, which a character that cannot be put into it does without.
bool settle_profile(const ProfileSettings& settings, std::string* to_pose);
// ".glb", or what the profile has.
std::string container_of(const ProfileSettings& settings);
// write_character(), or write_for_profile(), and the file of controls; remarks go to `notes`.
void write_as(const ProfileSettings& settings, const std::string& path, const Character& character,
              std::vector<std::string>* notes, const GlbOptions& glb = {}, const Morphs& morphs = {});

}  // namespace sinew::cli
#endif
