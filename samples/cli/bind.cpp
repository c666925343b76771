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
  unsigned jobs = 0;  // 0: not given
  bool json = false;
};

// Options that change the mesh need a file with one.
void check_mesh_changes(const BindSettings& one) {
  if (one.cut && one.symmetric)
    throw UsageError("--symmetric keeps both sides equal to the last bit and looks for no seams: leave out --cut");
  if (one.cut && one.no_seams) throw UsageError("--cut opens seams: leave out --no-seams");
  if ((one.cut || !one.to_pose.empty()) && !has_use(one.output, kWritesWithMesh))
    throw UsageError("--cut and --to-pose change the mesh, and rig.txt holds none; write a .glb");
}

// The options that no bind can be done with.
void check_bind(const BindCommandSettings& s) {
  check_output(s.one.output, kWritesSkin, true);
  if (!s.one.png.empty()) check_output(s.one.png, {".png"});
  if (!s.one.png_confidence.empty()) check_output(s.one.png_confidence, {".png"});
  if (!s.one.save_style.empty()) check_output(s.one.save_style, {".style"});
  if (s.one.ask && s.one.mesh == "-")
    throw UsageError("--ask and the mesh both read standard input; give the mesh as a file");
  if (s.one.ask && s.one.output == "-")
    throw UsageError("--ask writes pictures beside the output; give the output a file name");
  check_mesh_changes(s.one);
  if (s.one.output == "-" && s.json)
    throw UsageError("-o - and --json both write to standard output; give the weights a file name");
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
               " needs a folder of meshes, and " + s.one.mesh + " is not a folder");
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
               " takes one mesh, but " + s.one.mesh + " is a folder");
  if (s.one.output.empty()) throw UsageError(s.one.mesh + " is a folder; give -o OUTDIR for its files");
  std::error_code ignored;
  const bool is_file = has_use(s.one.output, kWritesSkin) || std::filesystem::is_regular_file(s.one.output, ignored);
  if (s.one.output == "-" || is_file)
    throw UsageError("-o " + s.one.output + ": " + s.one.mesh + " is a folder, expected -o to name a folder too");
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
  s.one.pose_preferred = settle_profile(s.one.profile, &s.one.to_pose);
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

// Options that most binds need.
void add_bind_inputs(CLI::App* sub, BindCommandSettings* s) {
  sub->add_option("mesh", s->one.mesh,
                  "Mesh, or a folder with all its subfolders. " + mesh_files() + ", or - for an OBJ on standard input")
      ->required()
      ->type_name("MESH|DIR");
  shared_option(sub, "--skeleton", s->one.skeleton,
                skeleton_files() + ". By default that of the mesh; in a folder, NAME.rig.txt beside NAME.obj");
  shared_option(sub, "-o,--output", s->one.output,
                skin_output_text("for a folder, a folder that gets NAME.glb for each mesh, with the same subfolders"))
      ->default_str("MESH.bound.glb");
  shared_option(sub, "--model", s->model)->default_str("bundled");
  shared_option(sub, "--method", s->method,
                "heat: heat diffusion without a model; model: the network; distance: distance to bones, the published "
                "method, for comparison")
      ->check(CLI::IsMember({"heat", "model", "distance"}));
  shared_option(sub, "--joints", s->one.joints,
                "own: joints that already have weight in the file, per mesh; names: all but controls, slots, roots and "
                "joints beside the mesh; all; or a file of deforming joints, one name per line. By default own for a "
                "skinned file, else names");
  add_influences(sub, s->one.influences);
  sub->add_flag("--fit", s->one.fit,
                "Scale, rotate and move a skeleton that has other units or stands beside the mesh");
  sub->add_flag("--symmetric", s->one.symmetric,
                "Give mirrored vertices mirrored weights, equal to the last bit. Reports a character without a mirror "
                "plane x = c");
  sub->add_option(
         "--like", s->one.like,
         "Bound character as an example of style. Its weights are transferred where they fit, and guide the rest")
      ->type_name("SOURCE");
}

void add_outputs(CLI::App* sub, BindCommandSettings* s) {
  sub->add_flag("--ask", s->one.ask,
                "Ask on the terminal about parts in doubt. Draws each part beside the output; 3 questions, or as many "
                "as --questions");
  shared_option(sub, "--png", s->one.png, "The mesh with its joints, colored by weight");
  shared_flag(sub, "--json", s->json, "For a folder, one line per mesh");
  add_style_options(sub, &s->one.style);
}

void add_mesh_changes(CLI::App* sub, BindCommandSettings* s) {
  section(sub, "Changes to the mesh");
  shared_flag(sub, "--cut", s->one.cut);
  sub->add_flag("--no-seams", s->one.no_seams, "Let weight cross seams where parts are fused, as in the engine alone");
  shared_option(
      sub, "--to-pose", s->one.to_pose,
      "The mesh follows, its bends keep their volume; fused parts are cut first, and a file's own joints move along");
}

void add_artists_words(CLI::App* sub, BindCommandSettings* s) {
  section(sub, "Given joints and weights");
  sub->add_option("--never", s->one.never, "Joints that must not get weight, one name per line")->type_name("FILE");
  sub->add_flag("--keep-tips", s->one.keep_tips,
                "Let joints that only end a chain keep their weight. By default it goes to their parents");
  sub->add_flag("--bind-props", s->one.bind_props,
                "Also bind meshes without a skin. Even where they are attached to joints, or other meshes have skins");
  shared_option(sub, "--lock", s->one.lock);
  sub->add_option("--hints", s->one.hints,
                  "Given weights of some vertices, kept and used to guide their neighbors. A .rig.txt with skin lines "
                  "for these only, or a glTF of the same mesh where only these have weights")
      ->type_name("FILE");
  section(sub, "Questions about parts");
  shared_option(sub, "--questions", s->one.questions, "Lists them with alternatives for --answer")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_QUESTIONS)));
  sub->add_option("--answer", s->one.answers,
                  "Choose what a part moves with. rigid:JOINT, soft (as heat diffuses), hard (each vertex with its "
                  "strongest joint), softer, host (as the surface below it) or proposed. PART is the number that "
                  "--questions prints, or any vertex of the part; equal and mirrored parts get the same answer")
      ->type_name("PART=ANSWER");
  sub->add_option("--style", s->one.studio_style, "Style file whose answers apply to similar parts. Also for folders")
      ->type_name("FILE.style");
  sub->add_option(
         "--save-style", s->one.save_style,
         "Save the answers for characters of the same kind. Those of --style, then those of --ask and --answer")
      ->type_name("FILE.style");
}

void add_bind_rest(CLI::App* sub, BindCommandSettings* s) {
  section(sub, "Reports");
  sub->add_flag(
      "--changes", s->one.compare,
      "List the ten joints whose vertices changed most from the weights of the file (or of the skeleton's file)");
  sub->add_flag("--confidence", s->one.confidence,
                "Also write the confidence of each vertex, 0 to 1, as attribute _CONFIDENCE of a .glb");
  shared_option(sub, "--png-confidence", s->one.png_confidence, "Scaled to this character");
  section(sub, "Folders");
  add_jobs(sub, s->jobs)->default_str("1");
  shared_option(sub, "--report", s->report, "A picture and a row per mesh");
  shared_option(sub, "--format", s->format)->check(CLI::IsMember(format_names(kWritesSkin)))->default_str("glb");
  section(sub, "Other options");
  shared_option(sub, "--up", s->one.up)->check(CLI::IsMember({"y", "z"}))->capture_default_str();
  shared_option(sub, "--threads", s->one.threads,
                "For one mesh, each with its own memory; the result is the same for any N")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_THREADS)))
      ->capture_default_str();
}

}  // namespace

void add_bind(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("bind", "Predict skin weights of a mesh for a skeleton");
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
