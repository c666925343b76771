// SPDX-License-Identifier: MIT
// Springs of VRM 0.x (secondaryAnimation) as VRMC_springBone of 1.0: github.com/vrm-c/vrm-specification, specification/0.0 and
// VRMC_springBone-1.0.
#include <array>
#include <cmath>
#include <vector>

#include "gltf/gltf_source.hpp"
#include "gltf/vrm.hpp"

namespace sinew {
namespace {

constexpr double kTail = 0.07;  // meters from the last joint to where it points, as in 0.x

// A joint that ends a chain points to a node 7 cm further, which 1.0 wants to be there.
size_t add_tail(size_t leaf, Json* document) {
  Json& nodes = (*document)["nodes"];
  std::array<double, 3> along = {0, 1, 0};
  if (nodes[leaf].contains("translation")) along = nodes[leaf]["translation"].get<std::array<double, 3>>();
  const double length = std::hypot(along[0], along[1], along[2]);
  for (double& value : along) value = length > 0 ? kTail * value / length : 0;
  if (!(length > 0)) along[1] = kTail;
  const size_t tail = nodes.size();
  nodes.push_back({{"name", nodes[leaf].value("name", std::string("joint")) + "_end"}, {"translation", along}});
  nodes[leaf]["children"].push_back(tail);
  return tail;
}

// Chains below a node: where it forks, the first child goes on and the others begin chains of their own.
std::vector<std::vector<size_t>> chains_below(size_t root, Json* document) {
  std::vector<std::vector<size_t>> chains;
  std::vector<size_t> starts = {root};
  while (!starts.empty()) {
    std::vector<size_t> chain;
    size_t node = starts.back();
    starts.pop_back();
    for (;;) {
      chain.push_back(node);
      Json children = Json::array();
      for (const Json& child : (*document)["nodes"].at(node).value("children", Json::array()))
        if (!(*document)["nodes"].at(child.get<size_t>()).contains("mesh")) children.push_back(child);
      for (size_t c = children.size(); c > 1; --c) starts.push_back(children[c - 1].get<size_t>());
      if (children.empty()) break;
      node = children[0].get<size_t>();
    }
    chain.push_back(add_tail(chain.back(), document));
    chains.push_back(std::move(chain));
  }
  return chains;
}

// Forces keep their meaning if the body faces the opposite direction: x and z change sign, and 0.x has the opposite z
// axis.
Json direction_of(const Json& zero) { return {-zero.value("x", 0.0), zero.value("y", -1.0), zero.value("z", 0.0)}; }

Json joint_settings(const Json& group) {
  return {{"hitRadius", group.value("hitRadius", 0.02)},
          {"stiffness", group.value("stiffiness", 1.0)},
          {"gravityPower", group.value("gravityPower", 0.0)},
          {"gravityDir", direction_of(group.value("gravityDir", Json::object()))},
          {"dragForce", group.value("dragForce", 0.4)}};
}

// Adds the spheres of every group to `colliders` and returns the groups.
Json collider_groups(const Json& zero, Json* colliders) {
  Json groups = Json::array();
  for (const Json& old : zero) {
    Json numbers = Json::array();
    for (const Json& sphere : old.value("colliders", Json::array())) {
      numbers.push_back(colliders->size());
      colliders->push_back({{"node", old.at("node")},
                            {"shape",
                             {{"sphere",
                               {{"offset", vrm_zero_vector(sphere.value("offset", Json::object()))},
                                {"radius", sphere.value("radius", 0.0)}}}}}});
    }
    groups.push_back({{"colliders", std::move(numbers)}});
  }
  return groups;
}

}  // namespace

Json vrm_zero_vector(const Json& zero) { return {zero.value("x", 0.0), zero.value("y", 0.0), -zero.value("z", 0.0)}; }

Json vrm_springs_of_zero(const Json& secondary, Json* document) {
  Json colliders = Json::array(), springs = Json::array();
  const Json groups = collider_groups(secondary.value("colliderGroups", Json::array()), &colliders);
  for (const Json& group : secondary.value("boneGroups", Json::array()))
    for (const Json& root : group.value("bones", Json::array()))
      for (const std::vector<size_t>& chain : chains_below(root.get<size_t>(), document)) {
        Json joints = Json::array();
        for (const size_t node : chain) {
          Json joint = node == chain.back() ? Json::object() : joint_settings(group);
          joint["node"] = node;
          joints.push_back(std::move(joint));
        }
        Json spring = {{"name", group.value("comment", std::string())}, {"joints", std::move(joints)}};
        if (const Json near = group.value("colliderGroups", Json::array()); !near.empty())
          spring["colliderGroups"] = near;
        if (const int center = group.value("center", -1); center >= 0) spring["center"] = static_cast<unsigned>(center);
        springs.push_back(std::move(spring));
      }
  if (springs.empty()) return nullptr;
  Json out = {{"specVersion", "1.0"}, {"springs", std::move(springs)}};
  if (!colliders.empty()) {
    out["colliders"] = std::move(colliders);
    out["colliderGroups"] = groups;
  }
  return out;
}

}  // namespace sinew
