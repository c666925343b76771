// SPDX-License-Identifier: MIT
// sinew bind: one mesh, one skeleton, weights out; the options.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "bind_files.hpp"
#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew/published.h"
#include "sinew_formats/file_kinds.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct BindCommandSettings {
  BindSettings one;
  std::string model, method, report, format;
  unsigned jobs = 0;  // 0: not said
  bool json = false;
};

// What changes the mesh needs a file that has one.
void check_mesh_changes(const BindSettings& one) {
  if (one.cut && one.symmetric)
    throw UsageError("--symmetric keeps both sides alike to the last bit and looks for no seams: leave --cut out");
  if (one.cut && one.no_seams) throw UsageError("--cut opens seams: leave --no-seams out");
  if ((one.cut || !one.to_pose.empty()) && !has_use(one.output, kWritesWithMesh))
    throw UsageError("--cut and --to-pose change the mesh, and rig.txt has none: write a .glb");
}

// The options that no bind can be done with.
void check_bind(const BindCommandSettings& s) {
  check_output(s.one.output, kWritesSkin, true);
  if (!s.one.png.empty()) check_output(s.one.png, {".png"});
  if (!s.one.png_confidence.empty()) check_output(s.one.png_confidence, {".png"});
  if (!s.one.save_style.empty()) check_output(s.one.save_style, {".style"});
  if (s.one.ask && s.one.mesh == "-") throw UsageError("--ask and the mesh both want standard input");
  if (s.one.ask && s.one.output == "-")
    throw UsageError("--ask writes pictures beside the output: give it a file name");
  check_mesh_changes(s.one);
  if (s.one.output == "-" && s.json)
    throw UsageError("-o - and --json both want standard output: give the weights a file name");
}

// --joints takes a word or a file.
void settle_joints(BindSettings* one) {
  if (one->joints.empty() || one->joints == "own" || one->joints == "names" || one->joints == "all") return;
  one->deform = std::exchange(one->joints, "");
}

// A binder and what it stands on.
struct LoadedBinder {
  std::unique_ptr<LoadedModel> model;
  Binder binder;
};

bool needs_no_model(const BindCommandSettings& s) { return s.method == "heat" || s.method == "distance"; }

LoadedBinder load_binder(const BindCommandSettings& s) {
  LoadedBinder loaded;
  if (s.method == "distance") loaded.binder = {nullptr, s.method, SINEW_METHOD_DISTANCE};
  if (needs_no_model(s)) return loaded;
  loaded.model = load_model(s.model);
  loaded.binder = {&loaded.model->model, model_label(s.model)};
  return loaded;
}

void refuse_folder_options(const BindCommandSettings& s) {
  refuse_given({{"--jobs", s.jobs > 0}, {"--report", !s.report.empty()}, {"--format", !s.format.empty()}},
               " is for a folder of meshes, and " + s.one.mesh + " is none");
}

void check_folder(const BindCommandSettings& s) {
  refuse_given({{"--png", !s.one.png.empty()},
                {"--png-confidence", !s.one.png_confidence.empty()},
                {"--hints", !s.one.hints.empty()},
                {"--lock", !s.one.lock.empty()},
                {"--answer", !s.one.answers.empty()},
                {"--ask", s.one.ask},
                {"--save-style", !s.one.save_style.empty()},
                {"--controls", !s.one.profile.controls.empty()},
                {"--changes without --json", s.one.compare && !s.json}},
               " is for one mesh, and " + s.one.mesh + " is a folder");
  if (s.one.output.empty()) throw UsageError(s.one.mesh + " is a folder: say with -o OUTDIR where its files go");
  std::error_code ignored;
  const bool is_file = has_use(s.one.output, kWritesSkin) || std::filesystem::is_regular_file(s.one.output, ignored);
  if (s.one.output == "-" || is_file)
    throw UsageError("-o " + s.one.output + ": " + s.one.mesh + " is a folder, expected a folder for its files");
  if (!s.report.empty()) check_output(s.report, {".html", ".htm"});
}

void run_bind_folder(const BindCommandSettings& s) {
  check_folder(s);
  FolderSettings folder;
  folder.each = s.one;
  folder.folder = s.one.mesh;
  folder.output_folder = s.one.output;
  if (!s.format.empty()) folder.extension = "." + s.format;
  folder.report = s.report;
  folder.jobs = std::max(1u, s.jobs);
  folder.json = s.json;
  bind_folder(folder, load_binder(s).binder);
}

void run_bind(BindCommandSettings s) {
  settle_joints(&s.one);
  settle_profile(s.one.profile, &s.one.to_pose);
  constexpr unsigned kQuestions = 3;
  if (s.one.ask && s.one.questions == 0) s.one.questions = kQuestions;
  if (needs_no_model(s) && !s.model.empty())
    throw UsageError("--method " + s.method + " uses no model: leave out --model");
  std::error_code ignored;
  if (std::filesystem::is_directory(s.one.mesh, ignored)) return run_bind_folder(s);
  refuse_folder_options(s);
  if (s.one.output.empty()) s.one.output = stem_of(s.one.mesh) + ".bound" + container_of(s.one.profile);
  check_bind(s);
  const LoadedBinder loaded = load_binder(s);
  const BindSummary summary = bind_one(s.one, loaded.binder, stderr_is_terminal()).summary;
  if (s.json) {
    std::printf("%s\n", summary_json(summary).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return;
  }
  std::FILE* out = s.one.output == "-" ? stderr : stdout;
  for (const std::string& line : summary_lines(summary)) std::fprintf(out, "%s\n", line.c_str());
}

// What most binds need.
void add_bind_inputs(CLI::App* sub, BindCommandSettings* s) {
  sub->add_option(
         "mesh", s->one.mesh,
         "Mesh, or a folder: every mesh in it and below it. " + mesh_files() + ", or - for an OBJ on standard input")
      ->required()
      ->type_name("MESH|DIR");
  shared_option(sub, "--skeleton", s->one.skeleton,
                skeleton_files() +
                    ". Not needed when the mesh has its own; in a folder, NAME.rig.txt beside NAME.obj is "
                    "found");
  shared_option(
      sub, "-o,--output", s->one.output,
      skin_output_text("for a folder another folder, which gets NAME.glb for every mesh, below the same sub-folders"))
      ->default_str("MESH.bound.glb");
  shared_option(sub, "--model", s->model)->default_str("bundled");
  shared_option(sub, "--method", s->method,
                "heat: heat fields alone, no model; model: the network; distance: by distance to bones, the published "
                "way, for comparison")
      ->check(CLI::IsMember({"heat", "model", "distance"}));
  shared_option(sub, "--joints", s->one.joints,
                "own: mesh by mesh those that have weight in the file already; names: not controls, slots, roots and "
                "what stands beside the mesh; all; or a file with the joints that deform, one name per line; own for a "
                "skinned file, else names");
  add_influences(sub, s->one.influences);
  sub->add_flag("--fit", s->one.fit, "Scale, rotate and move a skeleton in other units or beside the mesh");
  sub->add_flag("--symmetric", s->one.symmetric,
                "Mirror images get mirrored weights, to the last bit. Says so when the character has no mirror plane "
                "x = c");
  sub->add_option("--like", s->one.like,
                  "A bound character as an example of style. Its weights are carried over where they fit and steer the "
                  "rest")
      ->type_name("SOURCE");
}

void add_outputs(CLI::App* sub, BindCommandSettings* s) {
  sub->add_flag(
      "--ask", s->one.ask,
      "Ask about parts in doubt on the terminal. With a picture of each beside the output; 3 questions unless "
      "--questions says otherwise");
  shared_option(sub, "--png", s->one.png, "The mesh with its joints, coloured by weight");
  shared_flag(sub, "--json", s->json, "With a folder one line of JSON for every mesh");
  add_style_options(sub, &s->one.style);
}

void add_mesh_changes(CLI::App* sub, BindCommandSettings* s) {
  section(sub, "What becomes of the mesh");
  shared_flag(sub, "--cut", s->one.cut);
  sub->add_flag("--no-seams", s->one.no_seams,
                "Weight may cross where parts have grown together, as the engine alone has it");
  shared_option(sub, "--to-pose", s->one.to_pose,
                "The mesh follows and its bends keep their volume; what has grown together is cut first, a file's own "
                "joints move with it");
}

void add_artists_words(CLI::App* sub, BindCommandSettings* s) {
  section(sub, "Joints and weights that are given");
  sub->add_option("--never", s->one.never, "Joints that must get no weight, one name per line")->type_name("FILE");
  sub->add_flag("--keep-tips", s->one.keep_tips,
                "Joints that only end a chain keep the weight they get. By default their parents have it");
  sub->add_flag("--bind-props", s->one.bind_props,
                "Bind meshes without a skin too, also where they hang on joints or others have skins");
  shared_option(sub, "--lock", s->one.lock);
  sub->add_option(
         "--hints", s->one.hints,
         "Weights of some vertices, which are kept and steer those around them. A .rig.txt with skin lines for "
         "these alone, or a glTF of the same mesh whose other vertices have none")
      ->type_name("FILE");
  section(sub, "Parts to ask about");
  shared_option(sub, "--questions", s->one.questions, "Lists them with alternatives for --answer")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_QUESTIONS)));
  sub->add_option(
         "--answer", s->one.answers,
         "What a part moves with. rigid:JOINT, soft (as heat flows), hard (each vertex with its strongest "
         "joint), softer, host (as what it lies on) or proposed. PART is the number that --questions prints, or "
         "any vertex of the part; equal and mirrored parts get the same")
      ->type_name("PART=ANSWER");
  sub->add_option("--style", s->one.studio_style,
                  "Style file: parts like those that it has answers for are answered without asking. For folders too")
      ->type_name("FILE.style");
  sub->add_option(
         "--save-style", s->one.save_style,
         "Keep the answers for other characters of the same kind. Those of --ask and --answer, behind those of "
         "--style")
      ->type_name("FILE.style");
}

void add_bind_rest(CLI::App* sub, BindCommandSettings* s) {
  section(sub, "What is told");
  sub->add_flag(
      "--changes", s->one.compare,
      "List the ten joints whose vertices changed most from the weights that the file (or the skeleton's) has");
  sub->add_flag("--confidence", s->one.confidence,
                "Also write how sure each vertex is, 0 to 1, as the attribute _CONFIDENCE of a .glb");
  shared_option(sub, "--png-confidence", s->one.png_confidence, "Scaled to this character");
  section(sub, "A folder of meshes");
  add_jobs(sub, s->jobs)->default_str("1");
  shared_option(sub, "--report", s->report, "A picture and a row of every mesh");
  shared_option(sub, "--format", s->format)->check(CLI::IsMember(format_names(kWritesSkin)))->default_str("glb");
  section(sub, "The rest");
  shared_option(sub, "--up", s->one.up)->check(CLI::IsMember({"y", "z"}))->capture_default_str();
  shared_option(sub, "--threads", s->one.threads,
                "On one mesh, each with some memory of its own; the same bytes for any N")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_THREADS)))
      ->capture_default_str();
}

}  // namespace

void add_bind(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("bind", "Predict the skin weights of a mesh for a skeleton");
  auto s = std::make_shared<BindCommandSettings>();
  add_bind_inputs(sub, s.get());
  add_outputs(sub, s.get());
  add_artists_words(sub, s.get());
  add_mesh_changes(sub, s.get());
  add_transform_options(sub, &s->one.transform);
  add_bind_rest(sub, s.get());
  add_profile_options(sub, &s->one.profile);
  add_controls_option(sub, &s->one.profile);
  sub->footer(
      "Examples:\n  sinew bind hero.obj --skeleton hero.rig.txt -o hero.glb --png hero.png\n"
      "  sinew bind hero.glb --ask -o hero.bound.glb\n"
      "  sinew bind characters -o bound --jobs 4 --report bound.html\n\n"
      "  sinew bind hero.glb --method heat --influences 8 -o hero.rig.txt\n"
      "  sinew bind villain.obj --skeleton villain.rig.txt --like hero.glb -o villain.glb\n"
      "  sinew bind hero.obj --skeleton hero.rig.txt --hints painted.rig.txt -o hero.glb\n"
      "  sinew bind hero.glb --to-pose t -o hero.bound.glb\n"
      "  sinew bind hero.glb --questions 3 -o hero.bound.glb\n"
      "  sinew bind hero.glb --answer 812=rigid:Head --answer 40=soft -o hero.bound.glb\n"
      "  sinew bind hero.glb --ask --save-style my.style && sinew bind others -o bound --style my.style\n"
      "  cat hero.obj | sinew bind - --skeleton hero.rig.txt -o - > weights.rig.txt");
  sub->callback([s] { run_bind(*s); });
}

}  // namespace sinew::cli
