// SPDX-License-Identifier: MIT
// sinew bind: one mesh, one skeleton, weights out; the options.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "bind_one.hpp"
#include "commands.hpp"
#include "sinew_formats/file_names.hpp"
#include "style_options.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct Settings {
  BindSettings one;
  std::string model, method;
  bool json = false, all_joints = false;
};

// The options that no bind can be done with.
void check(const Settings& s) {
  check_output(s.one.output, {".glb", ".rig.txt"}, true);
  if (!s.one.png.empty()) check_output(s.one.png, {".png"});
  if (!s.one.png_confidence.empty()) check_output(s.one.png_confidence, {".png"});
  if (s.method == "heat" && !s.model.empty()) throw UsageError("--method heat uses no model: leave out --model");
  if (s.one.output == "-" && s.json)
    throw UsageError("-o - and --json both want standard output: give the weights a file name");
}

// A file of joints is what --deform takes.
void settle_joints(Settings* s) {
  BindSettings& one = s->one;
  if (s->all_joints) {
    if (!one.joints.empty() && one.joints != "all")
      throw UsageError("--all-joints and --joints " + one.joints + ": give one of the two");
    one.joints = "all";
  }
  if (one.joints.empty() || one.joints == "own" || one.joints == "names" || one.joints == "all") return;
  if (!one.deform.empty()) throw UsageError("--joints " + one.joints + " and --deform: give one list of joints");
  one.deform = std::exchange(one.joints, "");
}

void run(Settings s) {
  settle_joints(&s);
  if (s.one.output.empty()) s.one.output = stem_of(s.one.mesh) + ".bound.glb";
  check(s);
  std::unique_ptr<LoadedModel> model;
  Binder binder;
  if (s.method != "heat") {
    model = load_model(s.model);
    binder.model = &model->model;
    binder.name = s.model.empty() ? "bundled model" : file_name(s.model);
  }
  const BindSummary summary = bind_one(s.one, binder, isatty(STDERR_FILENO) != 0).summary;
  if (s.json) {
    std::printf("%s\n", summary_json(summary).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return;
  }
  std::FILE* out = s.one.output == "-" ? stderr : stdout;
  for (const std::string& line : summary_lines(summary)) std::fprintf(out, "%s\n", line.c_str());
}

}  // namespace

void add_bind(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("bind", "Predict the skin weights of a mesh for a skeleton");
  auto s = std::make_shared<Settings>();
  sub->add_option("mesh", s->one.mesh, "Mesh: .obj, .gltf, .glb, .vrm, or - for an OBJ on standard input")
      ->required()
      ->type_name("MESH");
  sub->add_option("--skeleton", s->one.skeleton,
                  "Skeleton: .rig.txt, .gltf, .glb or .vrm. Not needed when the mesh has its own")
      ->type_name("FILE");
  sub->add_option("-o,--output", s->one.output,
                  "Output: .glb or .rig.txt, - for rig.txt on standard output [MESH.bound.glb]")
      ->type_name("OUT");
  sub->add_option("--model", s->model, "Model file [the bundled one]")->type_name("FILE");
  sub->add_option("--method", s->method, "heat: heat fields alone, no model; model: the network")
      ->check(CLI::IsMember({"heat", "model"}));
  sub->add_option("--influences", s->one.influences, "Most joints per vertex")
      ->check(CLI::Range(1, 12))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--deform", s->one.deform, "Joints that deform, one name per line; all others get no weight")
      ->type_name("FILE");
  sub->add_option("--never", s->one.never, "Joints that must get no weight, one name per line")->type_name("FILE");
  sub->add_option("--joints", s->one.joints,
                  "Which joints may get weight: own (mesh by mesh those that have weight in the file already), names "
                  "(not controls, slots, roots and what stands beside the mesh), all, or a file like --deform's "
                  "[own for a skinned file, else names]")
      ->type_name("own|names|all|FILE");
  sub->add_flag("--all-joints", s->all_joints, "Same as --joints all");
  sub->add_flag("--keep-tips", s->one.keep_tips,
                "Joints that only end a chain keep the weight they get; by default their parents have it");
  sub->add_flag("--bind-props", s->one.bind_props,
                "Bind meshes without a skin too, also where they hang on joints or others have skins");
  sub->add_flag("--fit", s->one.fit, "Scale, turn and move a skeleton that is in other units or beside the mesh");
  sub->add_option("--lock", s->one.lock, "Vertices that keep the weights they have, one 0-based index per line")
      ->type_name("FILE");
  sub->add_option(
         "--hints", s->one.hints,
         "Weights of some vertices, a .rig.txt with skin lines for these alone (or a glTF of the same mesh whose "
         "other vertices have none): they are kept and steer the vertices around them")
      ->type_name("FILE");
  sub->add_option("--up", s->one.up, "Axis that points up")->check(CLI::IsMember({"y", "z"}))->capture_default_str();
  sub->add_option("--threads", s->one.threads,
                  "Threads that work on the mesh, each with some memory of its own; the same bytes for any N")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_THREADS)))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--png", s->one.png, "Also draw the mesh with its joints, coloured by weight")->type_name("FILE");
  add_style_options(sub, &s->one.style);
  sub->add_flag("--symmetric", s->one.symmetric,
                "Vertices and joints that are mirror images get mirrored weights, to the last bit; says so when the "
                "character has no mirror plane x = c");
  sub->add_flag("--confidence", s->one.confidence,
                "Also write how sure each vertex is, 0 to 1, as the attribute _CONFIDENCE of a .glb");
  sub->add_option("--png-confidence", s->one.png_confidence,
                  "Also draw where to look: dark blue = sure, yellow = half, red = not at all")
      ->type_name("FILE");
  sub->add_flag("--json", s->json, "Print the summary as JSON");
  sub->footer(
      "Examples:\n  sinew bind hero.obj --skeleton hero.rig.txt -o hero.glb --png hero.png\n"
      "  sinew bind hero.glb --method heat --influences 8 -o hero.rig.txt\n"
      "  sinew bind hero.obj --skeleton hero.rig.txt --hints painted.rig.txt -o hero.glb\n"
      "  cat hero.obj | sinew bind - --skeleton hero.rig.txt -o - > weights.rig.txt");
  sub->callback([s] { run(*s); });
}

}  // namespace sinew::cli
