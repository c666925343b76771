// SPDX-License-Identifier: MIT
// The extension of a VRM put into a document.
#ifndef SINEW_FORMATS_GLTF_VRM_WRITE_HPP
#define SINEW_FORMATS_GLTF_VRM_WRITE_HPP

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sinew_formats/vrm.hpp"

namespace sinew {

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
