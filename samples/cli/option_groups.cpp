// SPDX-License-Identifier: MIT
// How the groups look on the command line, and what they mean to the jobs.
#include "option_groups.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>

#include "options.hpp"
#include "sinew/published.h"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/jobs/picture_job.hpp"
#include "sinew_character/profile/controls.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {

void add_style_options(CLI::App* sub, StyleOptions* style) {
  section(sub, "Style");
  word_option(sub, "--rigid-parts", style->rigid_parts, kRigidParts,
              "When connected parts move with one joint each. always: toys, robots, armor; never: only where the heat "
              "field does so; auto: the model decides")
      ->type_name("WHEN");
  sub->add_option("--softness", style->softness,
                  "Softness of the blend between joints: 2 twice as soft, 0.5 half as soft")
      ->type_name("X")
      ->check(CLI::Range(0.25, 4.0))
      ->capture_default_str();
  sub->add_option("--surface-vertices", style->surface_vertices,
                  "Bind larger meshes on a surface reduced to N vertices. Weights are then interpolated, which takes "
                  "less time and memory")
      ->check(CLI::Range(16, static_cast<int>(SINEW_MAX_VERTICES)))
      ->capture_default_str()
      ->type_name("N");
}

void apply_style(const StyleOptions& style, BindOptions* options) {
  if (options->method != SINEW_METHOD_MODEL && style.softness != 1)
    throw UsageError("--softness needs the model's weights: leave it out with --method heat or distance");
  options->rigid_parts = style.rigid_parts;
  options->surface_vertices = style.surface_vertices;
  options->softness_percent = static_cast<uint32_t>(std::lround(style.softness * 100));
}

std::string style_text(const StyleOptions& style) {
  const StyleOptions usual;
  std::string text;
  if (style.rigid_parts != usual.rigid_parts) text += " --rigid-parts " + kRigidParts[style.rigid_parts];
  if (style.softness != usual.softness) text += print(" --softness %g", style.softness);
  if (style.surface_vertices != usual.surface_vertices) text += print(" --surface-vertices %u", style.surface_vertices);
  return text;
}

std::optional<sinew_deform_options> deform_options(const DeformSettings& settings) {
  sinew_deform_options options = SINEW_INIT(sinew_deform_options);
  options.cell_count = settings.cells;
  options.round_count = settings.rounds;
  options.body_contact = settings.body_contact ? 1 : 0;
  if (settings.method == "xpbd") options.method = SINEW_DEFORM_XPBD;
  if (settings.method == "delta-mush") options.method = SINEW_DEFORM_DELTA_MUSH;
  const bool xpbd = options.method == SINEW_DEFORM_XPBD;
  if (settings.body_contact && settings.method != "volume" && !xpbd)
    throw UsageError("--body-contact needs --deform volume or xpbd");
  if (!xpbd && (settings.no_smoothing || settings.stiffness != 0 || settings.tet_weights != SINEW_TET_WEIGHTS_SKIN ||
                settings.as_drawn))
    throw UsageError("--no-smoothing, --stiffness, --tet-weights and --as-drawn need --deform xpbd");
  options.as_drawn = settings.as_drawn ? 1 : 0;
  if (options.as_drawn != 0 && (settings.body_contact || settings.tet_weights != SINEW_TET_WEIGHTS_SKIN))
    throw UsageError("--as-drawn has its own contact and weights: leave out --body-contact and --tet-weights");
  if (settings.no_smoothing) options.without = SINEW_WITHOUT_SMOOTHING;
  options.energy = static_cast<uint32_t>(std::lround(1000 * settings.stiffness));
  options.tet_weights = settings.tet_weights;
  if (settings.method == "volume" || options.method != SINEW_DEFORM_VOLUME) return options;
  if (settings.cells != 0 || settings.rounds != 0)
    throw UsageError("--cells and --rounds need --deform volume, xpbd or delta-mush");
  return std::nullopt;
}

void add_deform_options(CLI::App* sub, const std::vector<std::string>& methods, const std::string& what,
                        DeformSettings* settings) {
  shared_option(sub, "--deform", settings->method,
                what +
                    "volume: bends keep their volume without self-intersection; xpbd: the published position-based "
                    "dynamics; delta-mush: smoothing that keeps the details of the rest shape")
      ->check(CLI::IsMember(methods));
}

void add_solver_options(CLI::App* sub, DeformSettings* settings) {
  section(sub, "Corrections");
  shared_option(sub, "--cells", settings->cells)->check(CLI::Range(8u, SINEW_MAX_DEFORM_CELLS))->default_str("32");
  shared_option(sub, "--rounds", settings->rounds)
      ->check(CLI::Range(1u, SINEW_MAX_DEFORM_ROUNDS))
      ->default_str("20, xpbd 60, delta-mush 5");
  shared_flag(sub, "--body-contact", settings->body_contact,
              "Arms keep out of the torso, thighs out of the belly and of each other");
  shared_option(sub, "--stiffness", settings->stiffness)
      ->check(CLI::Range(0.001, SINEW_MAX_DEFORM_ENERGY / 1000.0))
      ->default_str("0.2");
  shared_word_option(sub, "--tet-weights", settings->tet_weights, kTetWeights, "");
  shared_flag(sub, "--no-smoothing", settings->no_smoothing);
}

void add_drawn_correction(CLI::App* sub, DeformSettings* settings, const std::string& more) {
  shared_flag(sub, "--as-drawn", settings->as_drawn,
              "For --deform xpbd: bends are smoothed by a Laplacian and not inflated, tetrahedra get weights by "
              "distance, all contact is left to the solver" +
                  more);
}

void add_picture_options(CLI::App* sub, PictureOptions* options) {
  section(sub, "Pictures");
  sub->add_option("--mask", options->mask, "Mask of the figure, bright inside. By default found in the picture")
      ->type_name("FILE");
  sub->add_option("--mask-out", options->mask_out, "Write the mask that was found, white on black")
      ->type_name("FILE.png");
  sub->add_option("--figure", options->figure, "Number of the figure, from left to right. By default the largest")
      ->check(CLI::Range(1u, 99u))
      ->type_name("N");
  sub->add_option("--units", options->units,
                  "figure: longest side 1; pixels: picture coordinates, x right, y up from the bottom edge")
      ->type_name("UNITS")
      ->check(CLI::IsMember({"figure", "pixels"}))
      ->capture_default_str();
  sub->add_flag("--flat", options->flat, "Make a flat card instead of a body as thick as it is wide");
  sub->add_flag("--whole", options->whole,
                "Do not cut free arms that are drawn against the body. They are cut by default");
}

void add_picture_class(CLI::App* sub, PictureOptions* options) {
  sub->add_option("--class", options->body, std::string(kClassMeaning) + ". By default found")
      ->type_name("KIND")
      ->check(CLI::IsMember(body_class_words()));
}

void check_picture_options(const CLI::App& sub, const std::string& path) {
  if (is_picture(path)) return;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    for (const char* option : {"--mask", "--mask-out", "--figure"})
      if (sub.get_option(option)->count() > 0)
        throw UsageError(std::string(option) + " takes one picture, but " + path + " is a folder");
    return;
  }
  for (const char* option : {"--mask", "--mask-out", "--figure", "--units", "--flat", "--whole"})
    if (sub.get_option(option)->count() > 0)
      throw UsageError(std::string(option) + " is for pictures (" + picture_files() + "), but " + path + " is not one");
}

PictureJobOptions picture_job(const PictureOptions& options) {
  PictureJobOptions job;
  job.mask = options.mask;
  job.figure.number = options.figure;
  job.figure.cut = options.cut;
  job.mesh.pixels = options.units == "pixels";
  job.mesh.flat = options.flat;
  job.whole = options.whole;
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

namespace {

constexpr uint32_t kSpriteSide = 256;  // pixels

}  // namespace

void add_sprite_options(CLI::App* sub, SpriteSettings* settings) {
  sub->add_option("--sprites", settings->count,
                  "Number of frames per clip in a sprite sheet for 2D engines. Written beside the output: "
                  "NAME.sprites.png with NAME.sprites.json (a JSON hash as of TexturePacker and Aseprite)")
      ->check(CLI::Range(1u, 512u))
      ->type_name("N");
  sub->add_option("--loop", settings->loop, "Write the clips as an endless animated PNG")->type_name("FILE.png");
}

void check_sprite_options(const SpriteSettings& settings, const std::string& path) {
  if (!settings.loop.empty()) check_output(settings.loop, {".png", ".apng"});
  if (is_picture(path)) return;
  refuse_given({{"--sprites", settings.count > 0}, {"--loop", !settings.loop.empty()}},
               " is for pictures, but " + path + " is not one");
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

void add_profile_options(CLI::App* sub, ProfileSettings* settings) {
  std::string names, about;
  for (const Profile& one : profiles()) {
    names += (names.empty() ? "" : "|") + std::string(one.name);
    about += (about.empty() ? "" : "; ") + std::string(one.about);
  }
  section(sub, "For another program");
  sub->add_option("--for", settings->profile, "Write for a program or format. " + about)->type_name(names);
  sub->add_flag("--keep-axes", settings->options.keep_axes,
                "With --for: keep axes, names and roots of the skeleton, as without --for");
  sub->add_option("--author", settings->options.authors,
                  "With --for vrm, vrm0: author; repeatable. [the file's own, else unknown, with a warning]")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub->add_option("--license,--licence", settings->options.license,
                  "With --for vrm, vrm0: permissions in the format's terms, "
                  "creditNotation=required,commercialUsage=corporation, or a web address. Permissions that are not "
                  "given are denied")
      ->type_name("KEY=VALUE,...");
  sub->add_option("--title", settings->options.title,
                  "With --for vrm, vrm0: name of the character. By default the file's")
      ->type_name("NAME");
}

void add_controls_option(CLI::App* sub, ProfileSettings* settings) {
  sub->add_option(
         "--controls", settings->controls,
         "Also write the joints of animator controls: legs, arms, feet, spine, head, fingers "
         "(formats/spec/controls.md). The Blender add-on builds the controls; a glTF stores them in its extras too")
      ->type_name("FILE.controls.json");
}

bool settle_profile(const ProfileSettings& settings, std::string* to_pose) {
  const ProfileOptions& said = settings.options;
  bool preferred = false;
  if (!settings.controls.empty()) check_output(settings.controls, {".json"});
  if (settings.profile.empty()) {
    if (!said.authors.empty() || !said.license.empty() || !said.title.empty() || said.keep_axes)
      throw UsageError("--author, --license, --title and --keep-axes need --for");
  } else {
    try {
      const Profile& profile = profile_named(settings.profile);
      check_profile(profile, said);
      preferred = to_pose != nullptr && to_pose->empty();
      if (preferred) *to_pose = profile.pose;
    } catch (const Error& error) {
      throw UsageError(std::string("--for ") + settings.profile + ": " + error.what());
    }
  }
  if (to_pose != nullptr && *to_pose == "none") to_pose->clear();
  return preferred;
}

std::string container_of(const ProfileSettings& settings) {
  return settings.profile.empty() ? ".glb" : profile_named(settings.profile).container;
}

void write_as(const ProfileSettings& settings, const std::string& path, const Character& character,
              std::vector<std::string>* notes, const GlbOptions& glb, const Morphs& morphs) {
  const bool controls = !settings.controls.empty();
  std::string text;
  if (settings.profile.empty()) {
    GlbOptions how = glb;
    if (controls) how.extras = controls_extras(text = controls_text(character));
    write_character(path, character, how, morphs);
  } else {
    const Profile& profile = profile_named(settings.profile);
    ProfileOptions options = settings.options;
    options.controls = controls;
    if (controls) text = controls_for_profile(profile, options, character);
    for (std::string& note : write_for_profile(profile, options, path, character, glb, morphs))
      notes->push_back(std::move(note));
  }
  if (!controls) return;
  write_text_file(settings.controls, text);
  for (const std::string& note : find_controls(character).notes) notes->push_back("controls: " + note);
}

}  // namespace sinew::cli
