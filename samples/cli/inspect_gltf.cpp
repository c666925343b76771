// SPDX-License-Identifier: MIT
// sinew inspect: what a glTF document holds beside the character.
#include <cstdio>
#include <utility>

#include "inspect_parts.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

void print_mesh(const GltfSummary& summary, const GltfMeshSummary& mesh) {
  std::printf("  %s  %zu vertices, %zu %s, ", mesh.name.c_str(), mesh.vertices, mesh.primitives,
              mesh.primitives == 1 ? "primitive" : "primitives");
  if (mesh.skin >= 0) {
    std::printf("skin %s", summary.skins[static_cast<size_t>(mesh.skin)].name.c_str());
  } else if (!mesh.joint.empty()) {
    std::printf("no skin, attached to joint %s", mesh.joint.c_str());
  } else {
    std::printf("no skin");
  }
  if (mesh.node.empty()) {
    std::printf(", not shown by any node");
  } else if (!mesh.in_scene) {
    std::printf(", not in the scene");
  }
  if (!mesh.morph_targets.empty())
    std::printf(", %zu morph targets (%s)", mesh.morph_targets.size(), joined(mesh.morph_targets).c_str());
  std::printf("\n");
}

void print_skin(const GltfSkinSummary& skin) {
  std::printf("  %s  %zu joints (%zu with weight), %zu %s\n", skin.name.c_str(), skin.joints, skin.joints_with_weight,
              skin.meshes, skin.meshes == 1 ? "mesh" : "meshes");
  if (skin.joints_apart == 0) {
    std::printf("    rest pose is the bind pose (largest deviation %.2g %% of the size)\n", 100 * skin.deviation);
  } else {
    std::printf("    rest pose is not the bind pose: %zu joints stand elsewhere, at most %.1f %% of the size (%s)\n",
                skin.joints_apart, 100 * skin.deviation, skin.farthest.c_str());
  }
}

}  // namespace

void print_gltf(const GltfSummary& summary) {
  if (!summary.generator.empty()) std::printf("generator     %s\n", summary.generator.c_str());
  std::printf("nodes         %zu\nmeshes        %zu\n", summary.nodes, summary.meshes.size());
  for (const GltfMeshSummary& mesh : summary.meshes) print_mesh(summary, mesh);
  std::printf("skins         %zu\n", summary.skins.size());
  for (const GltfSkinSummary& skin : summary.skins) print_skin(skin);
  if (!summary.images.empty()) std::printf("images        %zu\n", summary.images.size());
  for (const GltfImageSummary& image : summary.images) {
    if (image.bytes > 0) {
      std::printf("  %s  %zu bytes\n", image.name.c_str(), image.bytes);
    } else {
      std::printf("  %s  missing\n", image.name.c_str());
    }
  }
  std::printf("animations    %zu\n", summary.animations.size());
  for (const GltfAnimationSummary& animation : summary.animations)
    std::printf("  %s  %.2f s, %zu channels\n", animation.name.c_str(), animation.seconds, animation.channels);
  if (!summary.extensions_used.empty()) std::printf("extensions    %s\n", joined(summary.extensions_used).c_str());
  if (!summary.extensions_required.empty())
    std::printf("required      %s\n", joined(summary.extensions_required).c_str());
}

Json gltf_json(const GltfSummary& summary) {
  Json json = {{"generator", summary.generator}, {"nodes", summary.nodes}};
  json["meshes"] = Json::array();
  for (const GltfMeshSummary& mesh : summary.meshes) {
    Json one = {{"name", mesh.name},
                {"node", mesh.node},
                {"in_scene", mesh.in_scene},
                {"vertices", mesh.vertices},
                {"primitives", mesh.primitives}};
    one["skin"] = mesh.skin < 0 ? Json(nullptr) : Json(mesh.skin);
    one["joint"] = mesh.joint.empty() ? Json(nullptr) : Json(mesh.joint);
    one["morph_targets"] = mesh.morph_targets;
    json["meshes"].push_back(std::move(one));
  }
  json["skins"] = Json::array();
  for (const GltfSkinSummary& skin : summary.skins)
    json["skins"].push_back({{"name", skin.name},
                             {"joints", skin.joints},
                             {"joints_with_weight", skin.joints_with_weight},
                             {"meshes", skin.meshes},
                             {"rest_is_bind", skin.joints_apart == 0},
                             {"joints_apart", skin.joints_apart},
                             {"deviation", skin.deviation},
                             {"farthest_joint", skin.farthest}});
  json["materials"] = summary.materials;
  json["images"] = Json::array();
  for (const GltfImageSummary& image : summary.images)
    json["images"].push_back({{"name", image.name}, {"bytes", image.bytes}});
  json["animations"] = Json::array();
  for (const GltfAnimationSummary& animation : summary.animations)
    json["animations"].push_back(
        {{"name", animation.name}, {"seconds", animation.seconds}, {"channels", animation.channels}});
  json["extensions_used"] = summary.extensions_used;
  json["extensions_required"] = summary.extensions_required;
  return json;
}

}  // namespace sinew::cli
