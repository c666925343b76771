// SPDX-License-Identifier: MIT
#include <utility>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/node_parts.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

std::shared_ptr<const GltfSource> transformed_document(const std::string& name, const GltfSource& source,
                                                       const Affine& transform, const std::vector<Joint>& joints) {
  if (source.model.scenes.size() > 1)
    throw Error(name + ": has " + std::to_string(source.model.scenes.size()) +
                " scenes; expected one, to be turned or scaled as a whole");
  const GltfNodes nodes = gltf_nodes(name, source.model);
  GltfSource transformed = source;
  Json node = Json::object();
  const NodeParts parts = parts_of(transform, NodeParts{});
  node["name"] = "Placed";
  node["translation"] = parts.translation;
  node["rotation"] = parts.rotation;
  node["scale"] = parts.scale;
  node["children"] = Json::array();
  for (size_t n = 0; n < nodes.parents.size(); ++n)
    if (nodes.parents[n] < 0 && nodes.in_scene[n] != 0) node["children"].push_back(n);
  Json& document = transformed.document;
  const size_t added = document["nodes"].size();
  document["nodes"].push_back(std::move(node));
  if (document.contains("scenes") && !document["scenes"].empty())
    document["scenes"][0]["nodes"] = Json::array({added});
  else
    document["scenes"] = Json::array({{{"nodes", Json::array({added})}}});
  for (Affine& world : transformed.bind_pose.worlds) world = multiply(transform, world);
  transformed.bind_pose.worlds.resize(added);
  transformed.bind_pose.worlds.push_back(transform);
  for (Affine& frame : transformed.bind_pose.skin_frames) frame = multiply(transform, frame);
  transformed.joints = joints;
  return read_again(name, std::move(transformed));
}

}  // namespace sinew
