// SPDX-License-Identifier: MIT
// VRM's extensions: the nodes of an animation (VRMC_vrm_animation) read, VRMC_vrm and VRM of 0.x put into a document.
#ifndef SINEW_FORMATS_GLTF_VRM_HPP
#define SINEW_FORMATS_GLTF_VRM_HPP

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "sinew_formats/document_form.hpp"

namespace sinew {

struct HumanoidNodes {
  std::map<size_t, std::string> bones;  // by node: "leftUpperArm"
  std::set<int> others;                 // nodes whose movement stands for an expression or for where the eyes look
  bool left_out = false;                // some animation moves one of these

  const std::string* bone(size_t node) const {
    const auto found = bones.find(node);
    return found == bones.end() ? nullptr : &found->second;
  }
  bool carries_no_joint(int node) const { return others.count(node) != 0; }
};

// nullopt for a file without the extension. Throws Error for a broken one.
std::optional<HumanoidNodes> read_humanoid_nodes(const std::string& path, const GltfSource& source);

// The extension of a VRM put into a document.
struct GltfSource;

//   joint_nodes  [J]
// Of VRM 1.0: expressions, look-at and first person of a document that has VRMC_vrm already stay; humanoid and meta are the new ones. A document
// with the older extension VRM loses it. Of 0.x the other way round: expressions of VRMC_vrm become blend shape groups. Throws Error where a
// required bone is missing or named twice.
void add_vrm(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes, GltfSource* source);

// The extension VRM of 0.x.
nlohmann::json vrm_zero(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes,
                        const nlohmann::json& document);
// The node of each of VrmData::bones, checked.
std::map<std::string, int> humanoid_nodes(const std::string& path, const VrmData& vrm,
                                          const std::vector<int>& joint_nodes);

}  // namespace sinew
#endif
