// SPDX-License-Identifier: MIT
// Skinning matrices of the nodes as they stand; their scales.
#include <algorithm>
#include <cmath>
#include <string>

#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/gltf_summary.hpp"

namespace sinew {
namespace {

double unevenness(const Affine& m) {
  double least = 0, most = 0;
  for (size_t c = 0; c < 3; ++c) {
    const double scale = std::sqrt(m[c] * m[c] + m[4 + c] * m[4 + c] + m[8 + c] * m[8 + c]);
    least = c == 0 ? scale : std::min(least, scale);
    most = std::max(most, scale);
  }
  return least > 0 ? most / least : 1e9;
}

double scale_of(const Affine& m) { return std::cbrt(std::abs(determinant(m))); }

// A root joint's parent that is no joint, scaled.
void find_scale(const GltfSource& source, const GltfNodes& nodes, const std::vector<int>& joint_of, GltfRest* rest) {
  for (const int joint : source.joint_nodes) {
    const int above = nodes.parents[static_cast<size_t>(joint)];
    if (above < 0 || joint_of[static_cast<size_t>(above)] >= 0) continue;
    const double scale = scale_of(nodes.worlds[static_cast<size_t>(above)]);
    if (!(scale > 0) || std::abs(std::log(scale)) <= std::abs(std::log(rest->scale))) continue;
    rest->scale = scale;
    rest->scaled_by = source.model.nodes[static_cast<size_t>(above)].name;
  }
}

void find_unused_skins(const tinygltf::Model& model, GltfRest* rest) {
  std::vector<char> used(model.skins.size(), 0);
  for (const tinygltf::Node& node : model.nodes)
    if (node.skin >= 0 && node.mesh >= 0) used[static_cast<size_t>(node.skin)] = 1;
  for (size_t s = 0; s < used.size(); ++s)
    if (used[s] == 0)
      rest->unused_skins.push_back(model.skins[s].name.empty() ? "skin " + std::to_string(s) : model.skins[s].name);
}

}  // namespace

std::optional<GltfRest> gltf_rest(const Character& character) {
  if (character.gltf == nullptr || !same_joints(character.joints, character.gltf->joints)) return std::nullopt;
  const GltfSource& source = *character.gltf;
  const std::string where = character.name;
  const GltfNodes nodes = gltf_nodes(where, source.model);
  GltfRest rest;
  rest.agrees = source.bind_pose.agrees;
  rest.shown.assign(character.joints.size(), kIdentity);
  rest.mirrored.assign(character.joints.size(), 0);
  rest.uneven.assign(character.joints.size(), 1);
  std::vector<int> joint_of(source.model.nodes.size(), -1);
  for (size_t j = 0; j < source.joint_nodes.size() && j < character.joints.size(); ++j) {
    const size_t node = static_cast<size_t>(source.joint_nodes[j]);
    joint_of[node] = static_cast<int>(j);
    rest.mirrored[j] = determinant(nodes.worlds[node]) < 0 ? 1 : 0;
    rest.uneven[j] = unevenness(nodes.worlds[node]);
  }
  if (!source.path.empty()) find_scale(source, nodes, joint_of, &rest);  // other formats count in units of their own
  find_unused_skins(source.model, &rest);
  std::vector<char> known(character.joints.size(), 0);
  for (size_t s = 0; rest.agrees && s < source.model.skins.size(); ++s) {
    const std::vector<Affine> palette = skin_palette(where, source.model, nodes, static_cast<int>(s));
    const std::optional<Affine> back = inverse(source.bind_pose.skin_frames[s]);
    for (size_t k = 0; back && k < palette.size(); ++k) {
      const int joint = joint_of[static_cast<size_t>(source.model.skins[s].joints[k])];
      if (joint < 0 || known[static_cast<size_t>(joint)] != 0) continue;
      known[static_cast<size_t>(joint)] = 1;
      rest.shown[static_cast<size_t>(joint)] = multiply(palette[k], *back);
    }
  }
  return rest;
}

}  // namespace sinew
