// SPDX-License-Identifier: MIT
// Joints of another file as nodes of a glTF document.
#include <algorithm>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {

bool same_joints(const std::vector<Joint>& a, const std::vector<Joint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Joint& x, const Joint& y) {
    return x.name == y.name && (x.parent == y.parent || y.parent < 0) && x.position.x == y.position.x &&
           x.position.y == y.position.y && x.position.z == y.position.z;
  });
}

std::vector<int> add_joint_nodes(const std::string& path, const std::vector<Joint>& joints, Json* document) {
  Json& nodes = (*document)["nodes"];
  if (nodes.is_null()) nodes = Json::array();
  const size_t base = nodes.size();
  std::vector<int> numbers;
  std::vector<size_t> roots;
  for (size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joint.parent >= static_cast<int>(joints.size()))
      throw Error(path + ": cannot write, joint " + in_quotes(joint.name) + " has a parent that does not exist");
    size_t steps = 0;
    for (int up = joint.parent; up >= 0; up = joints[static_cast<size_t>(up)].parent)
      if (++steps > joints.size())
        throw Error(path + ": cannot write, joint " + in_quotes(joint.name) + " is in a cycle");
    const Vec3 from = joint.parent < 0 ? Vec3{} : joints[static_cast<size_t>(joint.parent)].position;
    const auto difference = [](float a, float b) { return static_cast<double>(a) - static_cast<double>(b); };
    nodes.push_back({{"name", joint.name},
                     {"translation",
                      {difference(joint.position.x, from.x), difference(joint.position.y, from.y),
                       difference(joint.position.z, from.z)}}});
    numbers.push_back(static_cast<int>(base + j));
    if (joint.parent < 0) roots.push_back(base + j);
  }
  for (size_t j = 0; j < joints.size(); ++j)
    if (joints[j].parent >= 0) nodes[base + static_cast<size_t>(joints[j].parent)]["children"].push_back(base + j);
  size_t top = roots.empty() ? 0 : roots[0];
  if (roots.size() > 1) {
    top = nodes.size();
    nodes.push_back({{"name", "skeleton"}, {"children", roots}});
  }
  if (document->contains("scenes") && !(*document)["scenes"].empty() && !roots.empty()) {
    const size_t scene = document->value("scene", size_t{0});
    (*document)["scenes"].at(scene)["nodes"].push_back(top);
  }
  return numbers;
}

}  // namespace sinew
