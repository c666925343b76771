// SPDX-License-Identifier: MIT
// The extension of a VRM 1.0 put into a document.
#ifndef SINEW_FORMATS_GLTF_VRM_WRITE_HPP
#define SINEW_FORMATS_GLTF_VRM_WRITE_HPP

#include <string>
#include <vector>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/vrm.hpp"

namespace sinew {

//   joint_nodes  [J]
// Expressions, look-at and first person of a document that has VRMC_vrm already stay; humanoid and meta are the new ones. A document with
// the older extension VRM loses it. Throws Error where a required bone is missing or named twice.
void add_vrm(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes, GltfSource* source);

}  // namespace sinew
#endif
