// SPDX-License-Identifier: MIT
// sinew inspect: what is in a mesh, character, checkpoint or model file.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "commands.hpp"
#include "features/features.hpp"
#include "inspect_parts.hpp"
#include "model/layers.hpp"
#include "options.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InspectCommandSettings {
  std::string path;
  bool json = false;
};

std::string feature_set_text(uint32_t set) {
  return std::to_string(set & ~kFeatureFlags) +
         ((set & kAttributesFlag) != 0
              ? ", published attributes only: positions, normals, curvatures, Laplacian, distances to joints"
              : "") +
         ((set & kSpectralFlag) != 0 ? ", with spectral signatures" : "");
}

std::string grid_text(uint32_t cells) {
  return cells == 0 ? std::string("follows the vertices") : std::to_string(cells) + " cells";
}

void print_json(const Json& json) {
  Json whole = {{"sinew_inspect", 1}};
  whole.update(json);
  std::printf("%s\n", whole.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

size_t parameter_count(const FloatNetwork& network) {
  size_t parameters = 0;
  for (const LinearParameters& p : network.parameters) parameters += p.weights.size() + p.bias.size();
  return parameters;
}

Json checkpoint_json(const std::string& path, const Checkpoint& checkpoint) {
  const FloatNetwork& network = checkpoint.network;
  Json json = {{"file", path},
               {"kind", "checkpoint"},
               {"architecture", network.architecture},
               {"parameters", parameter_count(network)},
               {"candidates", network.candidate_count},
               {"grid", network.grid_size},
               {"feature_set", feature_set_text(network.feature_set)},
               {"steps", checkpoint.state.step},
               {"seconds", checkpoint.state.seconds}};
  if (checkpoint.state.best_score < 1e9) json["best_score"] = checkpoint.state.best_score;
  json["layers"] = Json::array();
  for (const Layer& layer : network.layers)
    json["layers"].push_back(
        {{"kind", traits_of(layer.kind).name}, {"in", layer.in.channels}, {"out", layer.out.channels}});
  const Json config = Json::parse(checkpoint.state.config_json, nullptr, false);
  json["config"] = config.is_discarded() ? Json(nullptr) : config;  // a released checkpoint has none
  return json;
}

void inspect_checkpoint(const InspectCommandSettings& s) {
  const std::string& path = s.path;
  const Checkpoint checkpoint = read_checkpoint(path);
  if (s.json) return print_json(checkpoint_json(path, checkpoint));
  const FloatNetwork& network = checkpoint.network;
  std::printf("%s: checkpoint, float network\n", path.c_str());
  std::printf("architecture  %s\nparameters    %zu\ncandidates    %u\ngrid          %s\nfeature set   %s\n",
              network.architecture.c_str(), parameter_count(network), network.candidate_count,
              grid_text(network.grid_size).c_str(), feature_set_text(network.feature_set).c_str());
  std::printf("trained       %llu steps, %.0f s", static_cast<unsigned long long>(checkpoint.state.step),
              checkpoint.state.seconds);
  if (checkpoint.state.best_score < 1e9) std::printf(", best score %.4f on val", checkpoint.state.best_score);
  std::printf("\n");
  std::printf("layers        %zu\n", network.layers.size());
  for (size_t l = 0; l < network.layers.size(); ++l) {
    const Layer& layer = network.layers[l];
    const char* domain = network.buffers[layer.out.buffer].domain == Domain::kPair ? "pair" : "vertex";
    std::printf("  %3zu  %-15s %4u -> %-4u %-6s%s%s\n", l, traits_of(layer.kind).name, layer.in.channels,
                layer.out.channels, domain, (layer.flags & kLayerRelu) != 0 ? " relu" : "",
                (layer.flags & kLayerResidual) != 0 ? " residual" : "");
  }
  std::printf("config        %s\n", checkpoint.state.config_json.c_str());
}

void inspect_model(const InspectCommandSettings& s) {
  constexpr const char* kTasks[] = {"skin weights", "skeletons", "hands", "skeletons in slots",
                                    "fronts"};  // by ModelUse
  ModelUse use = ModelUse::kBind;
  const std::unique_ptr<LoadedModel> loaded = load_any_model(s.path, &use);
  const char* const task = kTasks[static_cast<size_t>(use)];
  const sinew_model& model = loaded->model;
  if (s.json) {
    return print_json({{"file", s.path},
                       {"kind", "model"},
                       {"task", task},
                       {"format", model.format_version},
                       {"bytes", model.size_bytes},
                       {"parameters", model.parameter_count},
                       {"layers", model.layer_count},
                       {"candidates", model.candidate_count},
                       {"grid", model.grid_size},
                       {"feature_set", feature_set_text(model.feature_set)},
                       {"confidence_entries", model.confidence_count},
                       {"checksum", print("%08x", model.checksum)}});
  }
  std::printf("%s: int16 model, all checks passed\n", s.path == "bundled" ? "bundled model" : s.path.c_str());
  std::printf(
      "task          %s\nformat        %u\nbytes         %zu\nparameters    %u\nlayers        %u\n"
      "candidates    %u\ngrid          %s\nfeature set   %s\nchecksum      %08x\n",
      task, model.format_version, model.size_bytes, model.parameter_count, model.layer_count, model.candidate_count,
      grid_text(model.grid_size).c_str(), feature_set_text(model.feature_set).c_str(), model.checksum);
}

bool is_gltf(const std::string& path) {
  const FileKind* kind = file_kind(path);
  return kind != nullptr && kind->reader == FileReader::kGltf;
}

// A mesh alone is fine here; a rig beside an OBJ belongs to it.
Character read_what_is_there(const std::string& path) {
  const bool is_rig = has_extension(path, ".rig.txt");
  std::error_code ignored;
  if (is_rig && !std::filesystem::exists(path.substr(0, path.size() - 8) + ".obj", ignored)) {
    Character character;
    read_skeleton(path, false, &character);
    character.name = stem_of(path);
    return character;
  }
  return is_rig || has_rig_beside(path) ? read_character(path) : read_mesh(path);
}

// The parts of a file that is a mesh, a skeleton, a motion or several of these.
struct Contents {
  std::optional<GltfSummary> gltf;
  std::optional<Character> character;
  std::optional<Motion> motion;
};

// A file that has no motion, or none that can be read, beside a mesh is a mesh.
std::optional<Motion> motion_beside_mesh(const std::string& path) {
  if (!has_use(path, kReadsMotion)) return std::nullopt;
  try {
    return read_motion(path);
  } catch (const OutOfMemory&) {
    throw;
  } catch (const Error&) {
    return std::nullopt;
  }
}

Character skeleton_of(const Motion& motion) {
  Character character;
  character.name = motion.name;
  character.joints = rest_joints(motion);
  return character;
}

Contents contents_of(const std::string& path) {
  Contents contents;
  bool has_mesh = !is_motion_alone(path);
  if (is_gltf(path)) {
    contents.gltf = summarize_gltf(path);
    has_mesh = std::any_of(contents.gltf->meshes.begin(), contents.gltf->meshes.end(),
                           [](const GltfMeshSummary& mesh) { return mesh.in_scene && mesh.vertices > 0; });
  }
  if (is_motion_alone(path)) {
    contents.motion = read_motion(path);
  } else {
    contents.motion = motion_beside_mesh(path);
  }
  try {
    if (has_mesh) contents.character = read_what_is_there(path);
  } catch (const Error&) {
    if (!contents.motion) throw;  // a scene without a mesh
  }
  if (!contents.character && contents.motion) contents.character = skeleton_of(*contents.motion);
  return contents;
}

void inspect_contents(const InspectCommandSettings& s) {
  const Contents contents = contents_of(s.path);
  const bool has_mesh = contents.character && !contents.character->vertices.empty();
  const std::string kind = contents.motion && !has_mesh ? "motion"
                           : contents.character         ? character_kind(*contents.character)
                                                        : "glTF without a mesh";
  if (s.json) {
    Json json = {{"file", s.path}, {"kind", kind}};
    if (contents.character) json.update(character_json(*contents.character));
    if (contents.motion) json["motion"] = motion_json(*contents.motion);
    if (contents.gltf) json["gltf"] = gltf_json(*contents.gltf);
    return print_json(json);
  }
  std::printf("%s: %s\n", s.path.c_str(), kind.c_str());
  if (contents.gltf) print_gltf(*contents.gltf);
  if (contents.motion) print_motion(*contents.motion);
  if (contents.character) print_character(*contents.character);
}

void run_inspect(const InspectCommandSettings& s) {
  if (s.path == "bundled" || has_extension(s.path, ".sinew")) return inspect_model(s);
  if (has_use(s.path, kReadsSkeleton) || has_use(s.path, kReadsMesh) || s.path == "-") return inspect_contents(s);
  read_file(s.path);  // reports a missing file as such, not as an unknown kind
  if (is_checkpoint(s.path)) return inspect_checkpoint(s);
  throw Error(s.path + ": expected a mesh (" + extensions_text(kReadsMesh) + "), a motion (" +
              extensions_text(kReadsMotion) + "), a rig (.rig.txt), a checkpoint or a model (.sinew)" + remedy(s.path));
}

}  // namespace

void add_inspect(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("inspect", "Describe a mesh, character, motion, checkpoint or model");
  auto s = std::make_shared<InspectCommandSettings>();
  sub->add_option("file", s->path,
                  "Mesh, rig, character, motion, checkpoint or model. " + mesh_files() + ", " + skeleton_files() +
                      "; bundled = the model built into the program")
      ->required()
      ->type_name("FILE");
  shared_flag(sub, "--json", s->json);
  sub->footer(
      "Examples:\n  sinew inspect hero.glb\n  sinew inspect walk.npz\n\nFor a motion: joints, frames, frame rate, up "
      "axis, rest pose, and guesses.\nFor a glTF also: meshes and their skins, materials, images, animations, morph "
      "targets, extensions, and whether\nthe inverse bind matrices agree with the current node transforms.");
  sub->callback([s] { run_inspect(*s); });
}

}  // namespace sinew::cli
