// SPDX-License-Identifier: MIT
// VRMC_vrm_animation 1.0 (github.com/vrm-c/vrm-specification): a glTF of humanoid bones and their clips alone.
#include <algorithm>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

void write_vrm_animation(const std::string& path, const Motion& motion) {
  GltfSource source;
  source.document = {
      {"asset", {{"version", "2.0"}, {"generator", "sinew"}}}, {"scene", 0}, {"scenes", {{{"nodes", Json::array()}}}}};
  const std::vector<Joint> rest = rest_joints(motion);
  GltfJoints joints = {add_joint_nodes(path, rest, &source.document), {}};
  for (const Joint& joint : rest)
    joints.worlds.push_back({1, 0, 0, static_cast<double>(joint.position.x), 0, 1, 0,
                             static_cast<double>(joint.position.y), 0, 0, 1, static_cast<double>(joint.position.z)});
  write_gltf_motion(path, motion, joints, &source);
  Json bones = Json::object();
  for (size_t j = 0; j < motion.joints.size(); ++j) bones[motion.joints[j].name] = {{"node", joints.nodes[j]}};
  source.document["extensions"]["VRMC_vrm_animation"] = {{"specVersion", "1.0"},
                                                         {"humanoid", {{"humanBones", std::move(bones)}}}};
  source.document["extensionsUsed"] = {"VRMC_vrm_animation"};
  write_file(path, pack_glb(path, &source.document, std::move(source.bytes)));
}

}  // namespace sinew
