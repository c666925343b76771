// SPDX-License-Identifier: MIT
// sinew rig: a bare mesh in, a skeleton with weights out.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "progress.hpp"
#include "sinew_datasets/image.hpp"
#include "sinew_formats/bind_character.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/predict_skeleton.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string mesh, output, model, bind_model, png, up = "y", format = "glb";
  unsigned spine = 0, influences = 4;
  bool mirror = false, no_mirror = false, no_toes = false, no_ends = false, no_bind = false, json = false;
};

// The votes' own idea of how far off they are, share of the longest side. Above it nobody knows.
constexpr float kDoubtfulSpread = 0.08f;

struct Models {
  std::unique_ptr<LoadedModel> rig, bind;
};

Models load_models(const Settings& s) {
  Models models;
  models.rig = load_model(s.model, ModelUse::kRig);
  if (!s.no_bind) models.bind = load_model(s.bind_model);
  return models;
}

struct Rigged {
  Character character;
  PredictedSkeleton skeleton;
  double bind_seconds = 0;
};

Rigged rig_one(const Settings& s, const Models& models, const std::string& path) {
  Rigged rigged;
  Character& character = rigged.character;
  character = read_mesh(path);
  SkeletonOptions options;
  options.model = &models.rig->model;
  options.up_axis = s.up == "z" ? 1 : 0;
  options.mirror = s.mirror ? SINEW_MIRROR_ALWAYS : s.no_mirror ? SINEW_MIRROR_NEVER : SINEW_MIRROR_AUTO;
  options.spine_count = s.spine;
  options.toes = !s.no_toes;
  options.ends = !s.no_ends;
  rigged.skeleton = predict_skeleton(character, options);
  if (!character.joints.empty())
    character.notes.push_back("the file's own skeleton of " + std::to_string(character.joints.size()) +
                              " joints was left out; sinew bind keeps it");
  character.joints = rigged.skeleton.joints;
  character.influences.clear();
  if (rigged.skeleton.spread > kDoubtfulSpread)
    character.notes.push_back(
        "warning: this mesh resembles nothing that the model knows; look at the joints before using them");
  if (s.no_bind) return rigged;
  CharacterBindOptions bind;
  bind.bind.method = SINEW_METHOD_MODEL;
  bind.bind.model = &models.bind->model;
  bind.bind.influence_count = s.influences;
  bind.bind.up_axis = options.up_axis;
  bind.keep_tips = true;
  bind.bind_props = true;
  std::vector<uint8_t> said;
  for (const uint8_t end : rigged.skeleton.ends) said.push_back(end != 0 ? SINEW_JOINT_NEVER : SINEW_JOINT_DEFORMS);
  CharacterBind result = bind_character(character, choose_joints(character, JointsFrom::kAll, said), bind);
  character.influences = std::move(result.influences);
  rigged.bind_seconds = result.seconds;
  return rigged;
}

Json summary_json(const Settings& s, const Rigged& rigged, const std::string& mesh, const std::string& output) {
  const PredictedSkeleton& skeleton = rigged.skeleton;
  Json json;
  json["mesh"] = mesh;
  json["output"] = output;
  json["vertices"] = rigged.character.vertices.size();
  json["symmetric"] = skeleton.mirrored;
  json["spread"] = skeleton.spread;
  json["seconds"] = skeleton.seconds;
  json["workspace_bytes"] = skeleton.workspace_bytes;
  if (!s.no_bind) json["bind_seconds"] = rigged.bind_seconds;
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    Json one;
    one["name"] = joint.name;
    one["parent"] = joint.parent < 0 ? "" : skeleton.joints[static_cast<size_t>(joint.parent)].name;
    one["position"] = {joint.position.x, joint.position.y, joint.position.z};
    one["end"] = skeleton.ends[j] != 0;
    one["confidence"] = skeleton.confidence[j];
    one["parent_confidence"] = skeleton.parent_confidence[j];
    json["joints"].push_back(std::move(one));
  }
  json["notes"] = rigged.character.notes;
  return json;
}

void tell(const Settings& s, const Rigged& rigged, const std::string& mesh, const std::string& output, std::FILE* out) {
  if (s.json) {
    std::fprintf(out, "%s\n", json_line(summary_json(s, rigged, mesh, output)).c_str());
    return;
  }
  const PredictedSkeleton& skeleton = rigged.skeleton;
  size_t joints = 0;
  for (const uint8_t end : skeleton.ends) joints += end == 0 ? 1 : 0;
  std::fprintf(out, "%s: %zu joints and %zu bone ends, %s; %.0f ms%s\n", printable(mesh).c_str(), joints,
               skeleton.joints.size() - joints, skeleton.mirrored ? "symmetric" : "not symmetric",
               1e3 * skeleton.seconds, s.no_bind ? "" : print(", weights %.0f ms", 1e3 * rigged.bind_seconds).c_str());
  for (const std::string& note : rigged.character.notes) std::fprintf(out, "  %s\n", printable(note).c_str());
  if (output != "-") std::fprintf(out, "wrote %s\n", printable(output).c_str());
}

void write_rigged(const Settings& s, const Rigged& rigged, const std::string& output) {
  write_character(output, rigged.character);
  if (s.png.empty()) return;
  RenderOptions view;
  view.up_z = s.up == "z";
  const auto colours = rigged.character.influences.empty()
                           ? heat_colours(std::vector<float>(rigged.character.vertices.size(), 0.0f), 1.0f)
                           : weight_colours(rigged.character);
  write_file(s.png, encode_png(render(rigged.character, colours, view)));
}

void run_folder(const Settings& s) {
  if (s.output.empty()) throw UsageError(s.mesh + " is a folder: say with -o OUTDIR where its files go");
  if (!s.png.empty()) throw UsageError("--png is for one mesh, and " + s.mesh + " is a folder");
  const std::vector<std::string> paths = list_meshes(s.mesh), names = character_names(s.mesh, paths);
  if (paths.empty()) throw Error(s.mesh + ": no meshes (.obj, .gltf, .glb, .vrm, .fbx, .dae)");
  const Models models = load_models(s);
  size_t failed = 0;
  Progress progress(paths.size(), "meshes");
  for (size_t i = 0; i < paths.size(); ++i) {
    const std::string output = s.output + "/" + names[i] + "." + s.format;
    try {
      const Rigged rigged = rig_one(s, models, paths[i]);
      std::filesystem::create_directories(std::filesystem::path(output).parent_path());
      write_rigged(s, rigged, output);
      if (s.json) progress.say(stdout, json_line(summary_json(s, rigged, paths[i], output)));
    } catch (const Error& error) {
      ++failed;
      progress.say(stderr, "sinew: error: " + printable(error.what()));
    }
    progress.step();
  }
  if (failed > 0)
    throw Error(std::to_string(failed) + " of " + std::to_string(paths.size()) + " meshes failed, see above");
  if (!s.json) std::printf("wrote %zu files to %s\n", paths.size(), printable(s.output).c_str());
}

void run(Settings s) {
  if (s.mirror && s.no_mirror) throw UsageError("--mirror and --no-mirror: give one of the two");
  std::error_code ignored;
  if (std::filesystem::is_directory(s.mesh, ignored)) return run_folder(s);
  if (s.output.empty()) s.output = stem_of(s.mesh) + ".rigged.glb";
  check_output(s.output, {".glb", ".gltf", ".vrm", ".rig.txt"}, true);
  if (!s.png.empty()) check_output(s.png, {".png"});
  if (s.output == "-" && s.json)
    throw UsageError("-o - and --json both want standard output: give the skeleton a file name");
  const Rigged rigged = rig_one(s, load_models(s), s.mesh);
  write_rigged(s, rigged, s.output);
  tell(s, rigged, s.mesh, s.output, s.output == "-" ? stderr : stdout);
}

}  // namespace

void add_rig(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("rig", "Make a skeleton for a bare mesh, and bind the mesh to it");
  auto s = std::make_shared<Settings>();
  sub->add_option(
         "mesh", s->mesh,
         "Mesh: .obj, .gltf, .glb, .vrm, .fbx, .dae, or - for an OBJ on standard input; or a folder: every mesh "
         "in it and below it")
      ->required()
      ->type_name("MESH|DIR");
  sub->add_option(
         "-o,--output", s->output,
         "Output: .glb, .gltf with .bin, .vrm or .rig.txt, - for rig.txt on standard output [MESH.rigged.glb]; "
         "for a folder another folder")
      ->type_name("OUT");
  sub->add_option("--format", s->format, "With a folder: what to write")
      ->check(CLI::IsMember({"glb", "gltf", "rig.txt"}))
      ->capture_default_str();
  sub->add_option("--model", s->model, "Model of skeletons, or bundled = the one in the program [bundled]")
      ->type_name("FILE");
  sub->add_option("--bind-model", s->bind_model, "Model of weights, or bundled [bundled]")->type_name("FILE");
  sub->add_flag("--no-bind", s->no_bind, "The skeleton alone, without weights");
  sub->add_option("--influences", s->influences, "Most joints per vertex")
      ->check(CLI::Range(1, 12))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--up", s->up, "Axis that points up")->check(CLI::IsMember({"y", "z"}))->capture_default_str();
  sub->add_flag("--mirror", s->mirror, "Make both sides alike even where the mesh is not");
  sub->add_flag("--no-mirror", s->no_mirror, "Find both sides apart even where the mesh is its own mirror image");
  sub->add_option("--spine", s->spine, "Spine joints between the hips and the neck [as the model says]")
      ->check(CLI::Range(1, 16))
      ->type_name("N");
  sub->add_flag("--no-toes", s->no_toes, "Feet without toe joints");
  sub->add_flag("--no-ends", s->no_ends, "No NAME_end joints where chains end");
  sub->add_option("--png", s->png, "Also draw the mesh with its joints, coloured by weight")->type_name("FILE");
  sub->add_flag("--json", s->json, "Print joints and numbers as JSON; with a folder one line for every mesh");
  sub->footer(
      "Examples:\n  sinew rig hero.obj -o hero.glb --png hero.png\n"
      "  sinew rig hero.obj --no-bind -o hero.rig.txt && sinew bind hero.obj --skeleton hero.rig.txt\n"
      "  sinew rig meshes -o rigged");
  sub->callback([s] { run(*s); });
}

}  // namespace sinew::cli
