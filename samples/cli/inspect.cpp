// SPDX-License-Identifier: MIT
// sinew inspect: what is in a mesh, character, checkpoint or model file.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "commands.hpp"
#include "features/features.hpp"
#include "model/layers.hpp"
#include "sinew_datasets/dataset.hpp"
#include "sinew_formats/box.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

const char* layer_name(LayerKind kind) {
  switch (kind) {
    case LayerKind::kLinear:
      return "linear";
    case LayerKind::kRingMean:
      return "ring mean";
    case LayerKind::kRingMax:
      return "ring max";
    case LayerKind::kPartMean:
      return "part mean";
    case LayerKind::kGlobalMean:
      return "global mean";
    case LayerKind::kGlobalMax:
      return "global max";
    case LayerKind::kCandidateMax:
      return "candidate max";
    case LayerKind::kVertexToPair:
      return "vertex to pair";
    case LayerKind::kPairToVertex:
      return "pair to vertex";
    case LayerKind::kVertexToSlots:
      return "vertex to slots";
    case LayerKind::kCopy:
      return "copy";
  }
  return "unknown";
}

std::string feature_set_text(uint32_t set) {
  return std::to_string(set & ~kFeatureFlags) + ((set & kSpectralFlag) != 0 ? " with spectral signatures" : "");
}

void inspect_checkpoint(const std::string& path) {
  const Checkpoint checkpoint = read_checkpoint(path);
  const FloatNetwork& network = checkpoint.network;
  size_t parameters = 0;
  for (const LinearParameters& p : network.parameters) parameters += p.weights.size() + p.bias.size();
  std::printf("%s: checkpoint, float network\n", path.c_str());
  std::printf("architecture  %s\nparameters    %zu\ncandidates    %u\ngrid          %u cells\nfeature set   %s\n",
              network.architecture.c_str(), parameters, network.candidate_count, network.grid_size,
              feature_set_text(network.feature_set).c_str());
  std::printf("trained       %llu steps, %.0f s", static_cast<unsigned long long>(checkpoint.state.step),
              checkpoint.state.seconds);
  if (checkpoint.state.best_score < 1e9) std::printf(", best score %.4f on val", checkpoint.state.best_score);
  std::printf("\n");
  std::printf("layers        %zu\n", network.layers.size());
  for (size_t l = 0; l < network.layers.size(); ++l) {
    const Layer& layer = network.layers[l];
    const char* domain = network.buffers[layer.out.buffer].domain == Domain::kPair ? "pair" : "vertex";
    std::printf("  %3zu  %-15s %4u -> %-4u %-6s%s%s\n", l, layer_name(layer.kind), layer.in.channels,
                layer.out.channels, domain, (layer.flags & kLayerRelu) != 0 ? " relu" : "",
                (layer.flags & kLayerResidual) != 0 ? " residual" : "");
  }
  std::printf("config        %s\n", checkpoint.state.config_json.c_str());
}

void inspect_model(const std::string& path) {
  const std::unique_ptr<LoadedModel> loaded = load_model(path);
  const sinew_model& model = loaded->model;
  std::printf("%s: int16 model, all checks passed\n", path.empty() ? "bundled model" : path.c_str());
  std::printf(
      "format        %u\nbytes         %zu\nparameters    %u\nlayers        %u\ncandidates    %u\ngrid          %u "
      "cells\nfeature set   %s\nchecksum      %08x\n",
      model.format_version, model.size_bytes, model.parameter_count, model.layer_count, model.candidate_count,
      model.grid_size, feature_set_text(model.feature_set).c_str(), model.checksum);
}

void print_joints(const Character& character) {
  std::vector<std::vector<size_t>> children(character.joints.size());
  std::vector<double> share(character.joints.size(), 0.0);
  std::vector<std::pair<size_t, int>> stack;
  for (size_t j = character.joints.size(); j-- > 0;) {
    const int parent = character.joints[j].parent;
    if (parent < 0) {
      stack.emplace_back(j, 0);
    } else {
      children[static_cast<size_t>(parent)].push_back(j);
    }
  }
  for (const auto& row : character.influences) {
    for (const Influence& i : row) share[i.joint] += static_cast<double>(i.weight);
  }
  while (!stack.empty()) {
    const auto [j, depth] = stack.back();
    stack.pop_back();
    const Joint& joint = character.joints[j];
    std::printf("  %*s%s  (%.4g, %.4g, %.4g)", 2 * std::min(depth, 30), "", joint.name.c_str(),
                static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
                static_cast<double>(joint.position.z));
    if (!character.influences.empty()) std::printf("  %.1f vertices", share[j]);
    std::printf("\n");
    for (size_t child : children[j]) stack.emplace_back(child, depth + 1);
  }
}

void inspect_character(const std::string& path) {
  // A mesh alone is fine here; a rig beside an OBJ belongs to it.
  Character character;
  const bool is_rig = has_extension(path, ".rig.txt");
  std::error_code ignored;
  const bool has_rig = has_extension(path, ".obj") && std::filesystem::exists(rig_path_beside(path), ignored);
  if (is_rig && !std::filesystem::exists(path.substr(0, path.size() - 8) + ".obj", ignored)) {
    read_skeleton(path, false, &character);
    character.name = stem_of(path);
  } else {
    character = is_rig || has_rig ? read_character(path) : read_mesh(path);
  }
  std::printf("%s: %s\n", path.c_str(),
              character.vertices.empty()     ? "skeleton"
              : character.joints.empty()     ? "mesh"
              : character.influences.empty() ? "mesh and skeleton"
                                             : "character");
  if (!character.vertices.empty()) {
    const auto [low, high] = box_of(character.vertices);
    const CheckReport report = check_character(character);
    std::map<size_t, size_t> corners;
    for (size_t f = 0; f < character.face_count(); ++f)
      ++corners[character.face_offsets[f + 1] - character.face_offsets[f]];
    std::printf("vertices      %zu\nfaces         %zu (", character.vertices.size(), character.face_count());
    const char* comma = "";
    for (const auto& [count, faces] : corners) {
      std::printf("%s%zu with %zu corners", comma, faces, count);
      comma = ", ";
    }
    std::printf(")\nbox           (%.4g, %.4g, %.4g) .. (%.4g, %.4g, %.4g)\n", static_cast<double>(low.x),
                static_cast<double>(low.y), static_cast<double>(low.z), static_cast<double>(high.x),
                static_cast<double>(high.y), static_cast<double>(high.z));
    std::printf("parts         %zu\nboundary      %zu edges\nnon-manifold  %zu edges\n", report.parts,
                report.boundary_edges, report.non_manifold_edges);
    if (!character.material_names.empty()) std::printf("materials     %zu\n", character.material_names.size());
    if (!character.influences.empty())
      std::printf("influences    at most %zu per vertex, %zu vertices unbound\n", report.max_influences,
                  report.unbound_vertices);
  }
  if (!character.joints.empty()) {
    std::printf("joints        %zu\n", character.joints.size());
    print_joints(character);
  }
}

void run(const std::string& path) {
  if (path == "bundled") return inspect_model("");
  if (has_extension(path, ".obj") || has_extension(path, ".txt") || has_extension(path, ".glb") ||
      has_extension(path, ".gltf") || has_extension(path, ".vrm") || path == "-") {
    return inspect_character(path);
  }
  if (has_extension(path, ".sinew")) return inspect_model(path);
  read_file(path);  // a missing file is told as such, not as an unknown kind
  if (is_checkpoint(path)) return inspect_checkpoint(path);
  throw Error(path + ": neither a mesh (.obj, .gltf, .glb, .vrm), a rig (.rig.txt), a checkpoint nor a model (.sinew)");
}

}  // namespace

void add_inspect(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("inspect", "Say what is in a mesh, character, checkpoint or model");
  auto path = std::make_shared<std::string>();
  sub->add_option("file", *path,
                  "A mesh, rig, character, checkpoint or model; bundled = the model built into the program")
      ->required()
      ->type_name("FILE");
  sub->footer("Example:\n  sinew inspect hero.glb");
  sub->callback([path] { run(*path); });
}

}  // namespace sinew::cli
