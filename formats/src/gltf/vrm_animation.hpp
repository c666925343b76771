// SPDX-License-Identifier: MIT
// The nodes of a VRM animation (VRMC_vrm_animation): which bone of a humanoid each is.
#ifndef SINEW_FORMATS_GLTF_VRM_ANIMATION_HPP
#define SINEW_FORMATS_GLTF_VRM_ANIMATION_HPP

#include <map>
#include <optional>
#include <set>
#include <string>

#include "sinew_formats/character.hpp"

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

}  // namespace sinew
#endif
