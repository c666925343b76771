// SPDX-License-Identifier: MIT
// sinew simplify: a character or a skeleton with fewer joints, for levels of detail.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "sinew_character/jobs/simplify_job.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/gltf_summary.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SimplifyCommandSettings {
  std::string rig, mesh, level = "high", output;
  std::vector<std::string> keep;
  ProfileSettings profile;
  bool as_drawn = false, json = false;
};

SimplifyOptions parse_level(const SimplifyCommandSettings& s) {
  SimplifyOptions options;
  options.keep = s.keep;
  options.low = s.level == "low";
  options.as_drawn = s.as_drawn;
  if (s.level == "high" || s.level == "low") return options;
  const bool digits =
      !s.level.empty() && s.level.size() < 6 && s.level.find_first_not_of("0123456789") == std::string::npos;
  options.joints = digits ? static_cast<uint32_t>(std::stoul(s.level)) : 0;
  if (options.joints == 0) throw UsageError("--level " + s.level + ": expected high, low or a number of joints");
  return options;
}

// A skeleton alone, with the mesh beside it or with another one.
Character read_input(const SimplifyCommandSettings& s) {
  const bool text = has_extension(s.rig, ".txt");
  if (!s.mesh.empty()) {
    if (!text) throw UsageError("--mesh is for a skeleton without a mesh, but " + s.rig + " has one");
    Character character = read_mesh(s.mesh);
    read_skeleton(s.rig, true, &character);
    return character;
  }
  if (!text) return read_character(s.rig);
  const std::filesystem::path beside = std::filesystem::path(s.rig).parent_path() / (stem_of(s.rig) + ".obj");
  std::error_code ignored;
  if (has_extension(s.rig, ".rig.txt") && std::filesystem::exists(beside, ignored)) return read_character(s.rig);
  Character character;
  character.name = stem_of(s.rig);
  read_skeleton(s.rig, false, &character);
  return character;
}

// The file's own animations; none in files of other kinds.
std::optional<Motion> own_animations(const SimplifyCommandSettings& s) {
  if (has_extension(s.rig, ".txt") || has_extension(s.rig, ".obj") || summarize_gltf(s.rig).animations.empty())
    return std::nullopt;
  return read_gltf_motion(s.rig);
}

void run_simplify(const SimplifyCommandSettings& s) {
  const SimplifyOptions options = parse_level(s);
  settle_profile(s.profile, nullptr);
  check_output(s.output, kWritesCharacter, true);
  if (s.output == "-" && s.json)
    throw UsageError("-o - and --json both write to standard output; give the skeleton a file name");
  Character character = read_input(s);
  if (character.vertices.empty() && s.output != "-" && !has_extension(s.output, ".rig.txt"))
    throw UsageError(s.output + ": " + s.rig + " has no mesh; expected -o OUT.rig.txt, or --mesh MESH.obj beside it");
  const std::vector<Joint> before = character.joints;
  const auto noted = static_cast<std::ptrdiff_t>(character.notes.size());
  const std::optional<Motion> own = own_animations(s);
  std::vector<const Motion*> motions;
  if (own) motions.push_back(&*own);
  const SimplifiedCharacter left = simplify_character(options, motions, &character);
  const Simplified& simplified = left.simplified;
  GlbOptions glb;
  glb.drop_animations = true;
  glb.motion = &left.motion;
  std::vector<std::string> notes(character.notes.begin() + noted, character.notes.end());
  write_as(s.profile, s.output, character, &notes, glb);
  if (s.json) {
    Json json = {{"sinew_simplify", 1}};
    json["rig"] = s.rig;
    json["output"] = s.output;
    json["joints_before"] = before.size();
    json["joints"] = character.joints.size();
    for (size_t j = 0; j < before.size(); ++j)
      if (simplified.into[j] != j) json["into"][before[j].name] = before[simplified.into[j]].name;
    if (!notes.empty()) json["notes"] = notes;
    std::printf("%s\n", json_line(json).c_str());
    return;
  }
  std::FILE* const out = s.output == "-" ? stderr : stdout;
  std::fprintf(out, "%s: kept %zu of %zu joints\n", printable(s.rig).c_str(), character.joints.size(), before.size());
  if (options.joints > 0 && character.joints.size() > options.joints)
    std::fprintf(out, "  roots and joints of --keep are more than %u\n", options.joints);
  for (const std::string& note : notes) std::fprintf(out, "  %s\n", printable(note).c_str());
  if (s.output != "-") std::fprintf(out, "wrote %s\n", printable(s.output).c_str());
}

}  // namespace

void add_simplify(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("simplify", "Reduce the joints of a skeleton: levels of detail, with weights");
  auto s = std::make_shared<SimplifyCommandSettings>();
  sub->add_option("rig", s->rig, "Skinned file, NAME.obj with NAME.rig.txt, or a .rig.txt alone. " + mesh_files())
      ->required()
      ->type_name("RIG");
  shared_option(sub, "-o,--output", s->output,
                extensions_text(kWritesCharacter) + ", or - for rig.txt on standard output")
      ->required();
  sub->add_option(
         "--level", s->level,
         "Level of detail: high, low, or a number of joints. high: without bone ends, and without twists, helpers and "
         "face branches that animations move by less than 1 % of the height; low: also without fingers and small "
         "parts. Pelvis, spine, head, arms, legs, hands and feet stay; a number removes them last")
      ->type_name("high|low|N")
      ->capture_default_str();
  sub->add_option("--keep", s->keep, "Keep a joint; repeatable")->type_name("JOINT")->allow_extra_args(false);
  shared_flag(sub, "--as-drawn", s->as_drawn,
              "Apply its conditions to any joint, whatever its name or the animations; limbs may go");
  sub->add_option("--mesh", s->mesh, "Mesh that the weights of a .rig.txt belong to")->type_name("MESH");
  shared_flag(sub, "--json", s->json, "One line: which joint was merged into which");
  add_profile_options(sub, &s->profile);
  sub->footer(
      "Examples:\n  sinew simplify hero.glb --level low -o hero.far.glb\n"
      "  sinew simplify hero.rig.txt --level 20 --keep head -o hero20.rig.txt");
  sub->callback([s] { run_simplify(*s); });
}

}  // namespace sinew::cli
