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
  std::set<int> others;                 // nodes whose movement represents an expression or for where the eyes look
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
// Of VRM 1.0: expressions, look-at, first person and meta of a document that has VRMC_vrm already stay, but for what
// `vrm` says otherwise; humanoid is the new one. A document with the older extension VRM loses it, see
// turn_vrm_zero_into_one(). For 0.x the reverse: expressions and meta of VRMC_vrm become those of 0.x, its
// springs are left out. Returns remarks for the user. Throws Error where a required bone is missing or named twice.
std::vector<std::string> add_vrm(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes,
                                 GltfSource* source);

// Replaces an extension VRM of 0.x, if there is one and no newer, by VRMC_vrm and VRMC_springBone, whose chains get
// nodes at their ends. Vectors are in the axes that joints have in the file, names of bones those of 0.x:
// put_into_form() and add_vrm() follow. Returns remarks for the user.
std::vector<std::string> turn_vrm_zero_into_one(nlohmann::json* document);
// VRMC_springBone, or null where nothing swings.
nlohmann::json vrm_springs_of_zero(const nlohmann::json& secondary_animation, nlohmann::json* document);
// 0.x has the opposite z axis. {"x": 1, "y": 2, "z": 3} is [1, 2, -3].
nlohmann::json vrm_zero_vector(const nlohmann::json& zero);
// The name in 1.0 of an expression that 0.x knows; "" for others.
std::string vrm_preset_of_zero(const std::string& zero);

// Takes VRM's extension out of a document that lost its skeleton and got no new bones.
void drop_boneless_vrm(nlohmann::json* document);

// The extension VRM of 0.x.
nlohmann::json vrm_zero(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes,
                        const nlohmann::json& document);
// The node of each of VrmData::bones, checked.
std::map<std::string, int> humanoid_nodes(const std::string& path, const VrmData& vrm,
                                          const std::vector<int>& joint_nodes);

}  // namespace sinew
#endif
