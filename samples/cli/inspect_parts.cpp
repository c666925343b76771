// SPDX-License-Identifier: MIT
// Text and JSON of a character and a glTF for sinew inspect.
#include "inspect_parts.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "sinew_character/check/mesh_check.hpp"
#include "sinew_character/motion/motion_summary.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// Weight of each joint, summed over the vertices.
std::vector<double> joint_shares(const Character& character) {
  std::vector<double> share(character.joints.size(), 0.0);
  for (const auto& row : character.influences) {
    for (const Influence& i : row) share[i.joint] += static_cast<double>(i.weight);
  }
  return share;
}

// Faces of each number of corners.
std::map<size_t, size_t> face_sizes(const Character& character) {
  std::map<size_t, size_t> sizes;
  for (size_t f = 0; f < character.face_count(); ++f)
    ++sizes[character.face_offsets[f + 1] - character.face_offsets[f]];
  return sizes;
}

void print_joints(const Character& character) {
  const JointTree tree(character.joints);
  const std::vector<double> share = joint_shares(character);
  std::vector<std::pair<size_t, int>> stack;
  for (size_t j = character.joints.size(); j-- > 0;)
    if (character.joints[j].parent < 0) stack.emplace_back(j, 0);
  while (!stack.empty()) {
    const auto [j, depth] = stack.back();
    stack.pop_back();
    const Joint& joint = character.joints[j];
    std::printf("  %*s%s  (%.4g, %.4g, %.4g)", 2 * std::min(depth, 30), "", joint.name.c_str(),
                static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
                static_cast<double>(joint.position.z));
    if (!character.influences.empty()) std::printf("  %.1f vertices", share[j]);
    std::printf("\n");
    for (auto child = tree.children[j].rbegin(); child != tree.children[j].rend(); ++child)
      stack.emplace_back(joint_index(*child), depth + 1);
  }
}

nlohmann::ordered_json position_json(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

std::string character_kind(const Character& character) {
  return character.vertices.empty()     ? "skeleton"
         : character.joints.empty()     ? "mesh"
         : character.influences.empty() ? "mesh and skeleton"
                                        : "character";
}

void print_character(const Character& character) {
  if (!character.vertices.empty()) {
    const auto [low, high] = box_of(character.vertices);
    const CheckReport report = check_character(character);
    std::printf("vertices      %zu\nfaces         %zu (", character.vertices.size(), character.face_count());
    const char* comma = "";
    for (const auto& [count, faces] : face_sizes(character)) {
      std::printf("%s%zu with %zu corners", comma, faces, count);
      comma = ", ";
    }
    std::printf(")\nbox           (%.4g, %.4g, %.4g) .. (%.4g, %.4g, %.4g)\n", static_cast<double>(low.x),
                static_cast<double>(low.y), static_cast<double>(low.z), static_cast<double>(high.x),
                static_cast<double>(high.y), static_cast<double>(high.z));
    std::printf("parts         %zu\nboundary      %zu edges\nnon-manifold  %zu edges\n", report.parts,
                report.boundary_edges, report.non_manifold_edges);
    const char* before = "materials     ";
    for (const std::string& material : character.material_names) {
      std::printf("%s%s", before, material.c_str());
      before = ", ";
    }
    if (!character.material_names.empty()) std::printf("\n");
    if (!character.influences.empty())
      std::printf("influences    at most %zu per vertex, %zu vertices unbound\n", report.max_influences,
                  report.unbound_vertices);
  }
  if (!character.joints.empty()) {
    std::printf("joints        %zu\n", character.joints.size());
    print_joints(character);
  }
}

nlohmann::ordered_json character_json(const Character& character) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!character.vertices.empty()) {
    const auto [low, high] = box_of(character.vertices);
    const CheckReport report = check_character(character);
    json["vertices"] = character.vertices.size();
    json["faces"] = character.face_count();
    for (const auto& [corners, faces] : face_sizes(character))
      json["faces_by_corners"][std::to_string(corners)] = faces;
    json["box"] = {position_json(low), position_json(high)};
    json["parts"] = report.parts;
    json["boundary_edges"] = report.boundary_edges;
    json["non_manifold_edges"] = report.non_manifold_edges;
    json["materials"] = character.material_names;
    if (!character.influences.empty()) {
      json["max_influences"] = report.max_influences;
      json["unbound_vertices"] = report.unbound_vertices;
    }
  }
  const std::vector<double> share = joint_shares(character);
  json["joints"] = nlohmann::ordered_json::array();
  for (size_t j = 0; j < character.joints.size(); ++j) {
    const Joint& joint = character.joints[j];
    nlohmann::ordered_json one = {
        {"name", joint.name}, {"parent", joint.parent}, {"position", position_json(joint.position)}};
    if (!character.influences.empty()) one["vertices"] = share[j];
    json["joints"].push_back(std::move(one));
  }
  return json;
}

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
    std::printf("    rest pose is not the bind pose: %zu joints differ, at most %.1f %% of the size (%s)\n",
                skin.joints_apart, 100 * skin.deviation, skin.farthest.c_str());
  }
}

}  // namespace

namespace {

double seconds_of(const Clip& clip) {
  return clip.frames.empty() ? 0 : static_cast<double>(clip.frames.size() - 1) * clip.frame_time;
}

std::string up_of(const RestSummary& rest) { return rest.up ? std::string(1, "xyz"[axis_index(*rest.up)]) : ""; }

}  // namespace

void print_motion(const Motion& motion) {
  const RestSummary rest = rest_summary(motion);
  std::printf("clips         %zu\n", motion.clips.size());
  for (const Clip& clip : motion.clips)
    std::printf("  %s  %zu frames, %.4g per second, %.2f s\n", clip.name.c_str(), clip.frames.size(),
                1 / clip.frame_time, seconds_of(clip));
  std::printf("up            %s\nrest pose     %s\n", rest.up ? up_of(rest).c_str() : "unknown", rest.pose.c_str());
  for (const std::string& note : motion.notes) std::printf("note          %s\n", note.c_str());
}

Json motion_json(const Motion& motion) {
  const RestSummary rest = rest_summary(motion);
  Json json = {{"clips", Json::array()}, {"up", rest.up ? Json(up_of(rest)) : Json(nullptr)}, {"rest_pose", rest.pose}};
  for (const Clip& clip : motion.clips)
    json["clips"].push_back({{"name", clip.name},
                             {"frames", clip.frames.size()},
                             {"frames_per_second", 1 / clip.frame_time},
                             {"seconds", seconds_of(clip)}});
  json["notes"] = motion.notes;
  return json;
}

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
