// SPDX-License-Identifier: MIT
// sinew lod: a character with fewer triangles, level by level.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "options.hpp"
#include "profile_options.hpp"
#include "sinew_character/lod_job.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string character, output;
  LodOptions options;
  ProfileSettings profile;
  bool json = false;
};

// NAME.lod1.glb of NAME.glb.
std::string file_of(const std::string& output, size_t level) {
  const std::filesystem::path path(output);
  return (path.parent_path() / (stem_of(output) + ".lod" + std::to_string(level) + file_kind(output)->extension))
      .string();
}

void run(Settings s) {
  settle_profile(s.profile, nullptr);
  if (s.output.empty()) s.output = stem_of(s.character) + container_of(s.profile);
  check_output(s.output, kWholeOutputs);
  const Character character = open_character(s.character).character;
  std::vector<LodLevel> levels = levels_of_detail(s.options, character);
  for (size_t k = 0; k < levels.size(); ++k) {
    LodLevel& level = levels[k];
    const std::string file = file_of(s.output, k + 1);
    const bool fewer = s.options.joints && k > 0;
    GlbOptions glb;
    glb.keep_skin = !fewer;
    glb.drop_animations = fewer;
    glb.motion = fewer ? &level.motion : nullptr;
    std::vector<std::string> notes;
    write_as(s.profile, file, level.character, &notes, glb);
    if (s.json) {
      const Json json = {{"sinew_lod", 1},
                         {"level", k + 1},
                         {"output", file},
                         {"triangles", level.triangles},
                         {"vertices", level.character.vertices.size()},
                         {"joints", level.character.joints.size()},
                         {"rest_error", level.rest_error},
                         {"posed_error", level.posed_error},
                         {"mean_error", level.mean_error},
                         {"notes", notes}};
      std::printf("%s\n", json_line(json).c_str());
      continue;
    }
    std::printf(
        "level %zu: %zu of %zu triangles, %zu joints; up to %.2f %% of the height off at rest, %.2f %% in bent poses "
        "(mean %.3f %%)\n",
        k + 1, level.triangles, character.face_count(), level.character.joints.size(), 100 * level.rest_error,
        100 * level.posed_error, 100 * level.mean_error);
    for (const std::string& note : notes) std::printf("  %s\n", printable(note).c_str());
    std::printf("wrote %s\n", printable(file).c_str());
  }
}

}  // namespace

void add_lod(CLI::App& app) {
  CLI::App* sub =
      app.add_subcommand("lod", "Levels of detail: fewer triangles, with weights, shapes, seams and materials");
  auto s = std::make_shared<Settings>();
  sub->add_option("character", s->character, "Bound character. " + mesh_files())->required()->type_name("CHARACTER");
  shared_option(sub, "-o,--output", s->output,
                "NAME.lod1, NAME.lod2, ... of this name: " + extensions_text(kWholeOutputs))
      ->default_str("CHARACTER.glb");
  sub->add_option("--levels", s->options.levels, "How many")->check(CLI::Range(1, 8))->capture_default_str();
  sub->add_option("--triangles", s->options.ratio, "Of a level, as a share of the one before")
      ->check(CLI::Range(0.05, 0.95))
      ->type_name("SHARE")
      ->capture_default_str();
  sub->add_flag("--fewer-joints", s->options.joints,
                "Level 2 has the joints of sinew simplify --level high, further ones of low");
  shared_flag(sub, "--json", s->json, "A line for every level");
  add_profile_options(sub, &s->profile);
  sub->footer(
      "Examples:\n  sinew lod hero.glb\n  sinew lod hero.glb --levels 4 --triangles 0.4 --fewer-joints -o "
      "lods/hero.glb");
  sub->callback([s] { run(*s); });
}

}  // namespace sinew::cli
