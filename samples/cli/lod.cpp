// SPDX-License-Identifier: MIT
// sinew lod: a character with fewer triangles, level by level.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "sinew_character/jobs/lod_job.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/lod_document.hpp"
#include "sinew_formats/memory_files.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct LodCommandSettings {
  std::string character, output;
  LodOptions options;
  ProfileSettings profile;
  bool json = false, one_file = false;
};

// A character as a GLB that is not on the disk.
std::vector<uint8_t> glb_of(const LodCommandSettings& s, const Character& character, std::vector<std::string>* notes) {
  std::vector<NamedBytes> written;
  {
    const MemoryFiles scope(memory_inputs(), &written);
    GlbOptions glb;
    glb.keep_skin = true;
    write_as(s.profile, stem_of(s.output) + ".glb", character, notes, glb);
  }
  return std::move(written.at(0).bytes);
}

// NAME.lod1.glb of NAME.glb.
std::string file_of(const std::string& output, size_t level) {
  const std::filesystem::path path(output);
  return (path.parent_path() / (stem_of(output) + ".lod" + std::to_string(level) + file_kind(output)->extension))
      .string();
}

void run_lod(LodCommandSettings s) {
  settle_profile(s.profile, nullptr);
  if (s.output.empty()) s.output = stem_of(s.character) + (s.one_file ? ".lods.glb" : container_of(s.profile));
  check_output(s.output, kWritesWhole);
  if (s.one_file && !has_extension(s.output, ".glb"))
    throw UsageError("--one-file writes a .glb, but " + s.output + " is not one");
  if (s.one_file && s.options.joints)
    throw UsageError("--one-file: levels in one file share a skeleton; leave out --fewer-joints");
  const Character character = open_character(s.character).character;
  std::vector<LodLevel> levels = levels_of_detail(s.options, character);
  std::vector<std::vector<uint8_t>> glbs;
  std::vector<std::string> of_whole;
  if (s.one_file) glbs.push_back(glb_of(s, character, &of_whole));
  for (size_t k = 0; k < levels.size(); ++k) {
    LodLevel& level = levels[k];
    const std::string file = s.one_file ? s.output : file_of(s.output, k + 1);
    const bool fewer = s.options.joints && k > 0;
    GlbOptions glb;
    glb.keep_skin = !fewer;
    glb.drop_animations = fewer;
    glb.motion = fewer ? &level.motion : nullptr;
    std::vector<std::string> notes = level.character.notes;
    if (s.one_file)
      glbs.push_back(glb_of(s, level.character, &notes));
    else
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
    if (!s.one_file) std::printf("wrote %s\n", printable(file).c_str());
  }
  if (!s.one_file) return;
  write_file(s.output, glb_of_levels(s.output, glbs));
  if (!s.json) std::printf("wrote %s\n", printable(s.output).c_str());
}

}  // namespace

void add_lod(CLI::App& app) {
  CLI::App* sub =
      app.add_subcommand("lod", "Make levels of detail: fewer triangles, with weights, shapes, seams and materials");
  auto s = std::make_shared<LodCommandSettings>();
  sub->add_option("character", s->character, "Bound character. " + mesh_files())->required()->type_name("CHARACTER");
  shared_option(sub, "-o,--output", s->output,
                "Base name of the levels NAME.lod1, NAME.lod2, ...: " + extensions_text(kWritesWhole))
      ->default_str("CHARACTER.glb");
  sub->add_option("--levels", s->options.levels, "Number of levels")
      ->check(CLI::Range(1, 8))
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--triangles", s->options.ratio, "Triangles of a level as a share of the level before")
      ->check(CLI::Range(0.05, 0.95))
      ->type_name("SHARE")
      ->capture_default_str();
  sub->add_flag("--fewer-joints", s->options.joints,
                "Reduce joints: level 2 as sinew simplify --level high, later ones as low");
  sub->add_flag("--one-file", s->one_file,
                "Write the character and its levels into one .glb as extension MSFT_lod: CHARACTER.lods.glb");
  shared_flag(sub, "--json", s->json, "One line per level");
  add_profile_options(sub, &s->profile);
  sub->footer(
      "Examples:\n  sinew lod hero.glb\n  sinew lod hero.glb --levels 4 --triangles 0.4 --fewer-joints -o "
      "lods/hero.glb");
  sub->callback([s] { run_lod(*s); });
}

}  // namespace sinew::cli
