// SPDX-License-Identifier: MIT
// Springs as VRMC_springBone 1.0; planes and shapes that hold from inside as VRMC_springBone_extended_collider 1.0 with the fallbacks that its
// specification recommends.
#include <algorithm>
#include <cmath>

#include "gltf/spring_limits.hpp"
#include "gltf/springs.hpp"

namespace sinew {
namespace {

constexpr double kFar = 10000;         // below everything: a sphere of no size there pushes nothing
constexpr double kPlaneRadius = 1000;  // of the sphere that stands for a plane
constexpr double kSameEnd = 1e-5;      // share of a bone's length within which a node is its end

class SpringWriter {
 public:
  SpringWriter(const GltfJoints& joints, const Rotation& turn, Json* document)
      : joints_(joints), turn_(turn), document_(*document) {
    for (const Affine& world : joints.worlds) back_.push_back(inverse(world).value_or(kIdentity));
  }

  //   before  what the document has; null: nothing
  Json write(const Springs& springs, const Json& before) {
    Json out = before.is_object() ? before : Json{{"specVersion", "1.0"}};
    const auto number_in = [&out](const char* list, int source, const Json& made) {
      if (source >= 0) return static_cast<size_t>(source);
      out[list].push_back(made);
      return out[list].size() - 1;
    };
    std::vector<size_t> colliders, groups;
    for (const SpringCollider& one : springs.colliders)
      colliders.push_back(number_in("colliders", one.source, one.source < 0 ? collider_json(one) : Json()));
    for (const ColliderGroup& one : springs.groups) {
      Json made = {{"colliders", Json::array()}};
      for (const size_t c : one.colliders) made["colliders"].push_back(colliders[c]);
      if (!one.name.empty()) made["name"] = one.name;
      groups.push_back(number_in("colliderGroups", one.source, made));
    }
    Json chains = Json::array();
    for (const SpringChain& one : springs.chains)
      chains.push_back(one.source < 0 ? chain_json(one, groups)
                                      : changed_chain(one, before["springs"].at(static_cast<size_t>(one.source))));
    out["springs"] = std::move(chains);
    return out;
  }
  bool extended() const { return extended_; }
  bool limited() const { return limited_; }

 private:
  // A direction or a distance from the joint, in its node's axes.
  Point3 local(size_t joint, const Point3& v) const {
    Affine m = back_[joint];
    m[3] = m[7] = m[11] = 0;
    return transform_point(m, v[0], v[1], v[2]);
  }
  Point3 position(size_t joint) const {
    const Affine& m = joints_.worlds[joint];
    return {m[3], m[7], m[11]};
  }
  int node_of(size_t joint) const { return joints_.nodes[joint]; }

  Json collider_json(const SpringCollider& c) {
    Json out = {{"node", node_of(c.joint)}};
    if (!c.name.empty()) out["name"] = c.name;
    const Point3 offset = local(c.joint, c.offset), tail = local(c.joint, c.tail);
    const Json sphere = {{"offset", offset}, {"radius", c.radius}},
               capsule = {{"offset", offset}, {"tail", tail}, {"radius", c.radius}};
    if (c.shape == ColliderShape::kSphere) {
      out["shape"]["sphere"] = sphere;
      return out;
    }
    if (c.shape == ColliderShape::kCapsule) {
      out["shape"]["capsule"] = capsule;
      return out;
    }
    extended_ = true;
    Json shape;
    out["shape"]["sphere"] = {{"offset", {0, -kFar, 0}}, {"radius", 0}};
    if (c.shape == ColliderShape::kPlane) {
      shape["plane"] = {{"offset", offset}, {"normal", unit(tail)}};
      out["shape"]["sphere"] = {{"offset", offset - kPlaneRadius * unit(tail)}, {"radius", kPlaneRadius}};
    } else {
      const char* const kind = c.shape == ColliderShape::kInsideSphere ? "sphere" : "capsule";
      shape[kind] = c.shape == ColliderShape::kInsideSphere ? sphere : capsule;
      shape[kind]["inside"] = true;
    }
    out["extensions"]["VRMC_springBone_extended_collider"] = {{"specVersion", "1.0"}, {"shape", shape}};
    return out;
  }

  // A child without anything at the end, or a new one.
  size_t end_node(size_t joint, const Point3& end) {
    const Point3 at = local(joint, end);
    const size_t parent = static_cast<size_t>(node_of(joint));
    Json& nodes = document_["nodes"];
    for (const Json& child : nodes[parent].value("children", Json::array())) {
      const Json& one = nodes[child.get<size_t>()];
      if (one.contains("mesh") || one.contains("matrix") || !one.contains("translation")) continue;
      if (length(one["translation"].get<Point3>() - at) <= kSameEnd * length(at)) return child.get<size_t>();
    }
    const size_t made = nodes.size();
    nodes.push_back({{"name", nodes[parent].value("name", std::string("joint")) + "_end"}, {"translation", at}});
    nodes[parent]["children"].push_back(made);
    return made;
  }

  // Writes the limit of a joint that rotates into its JSON, unless it is there already.
  void set_limit(const SpringChain& chain, size_t turning, Json* joint) {
    const SpringJoint& one = chain.joints[turning];
    const Point3 at = position(one.joint);
    const bool last = turning + 1 == chain.joints.size();
    const Point3 bone = local(one.joint, last ? *chain.end : position(chain.joints[turning + 1].joint) - at);
    const Json made = spring_limit_json(one.limit, local(one.joint, one.hinge), bone);
    const Json::json_pointer place("/extensions/" + std::string(kSpringLimit));
    if (!made.is_null()) {
      const bool has = joint->contains(place);
      const SpringLimit before = has ? read_spring_limit((*joint)[place], bone) : SpringLimit();
      const bool same = has && std::abs(before.limit - one.limit) < 1e-6 &&
                        length(unit(before.hinge) - unit(local(one.joint, one.hinge))) < 1e-6;
      if (!same) (*joint)[place] = made;
      limited_ = true;
    }
  }

  // A chain of the document, with the numbers that its joints have now.
  Json changed_chain(const SpringChain& chain, Json json) {
    for (size_t i = 0; i < chain.joints.size(); ++i)
      for (Json& joint : json["joints"]) {
        const SpringJoint& one = chain.joints[i];
        if (joint["node"] != node_of(one.joint)) continue;
        const SpringJoint usual;
        const auto set = [&joint](const char* key, double value, double otherwise) {
          if (joint.value(key, otherwise) != value) joint[key] = value;
        };
        set("hitRadius", one.hit_radius, usual.hit_radius);
        set("stiffness", one.stiffness, usual.stiffness);
        set("gravityPower", one.gravity_power, usual.gravity_power);
        set("dragForce", one.drag, usual.drag);
        if (i < chain.turning_joints()) set_limit(chain, i, &joint);
      }
    return json;
  }

  Json chain_json(const SpringChain& chain, const std::vector<size_t>& groups) {
    Json joints = Json::array();
    for (size_t i = 0; i < chain.joints.size(); ++i) {
      const SpringJoint& one = chain.joints[i];
      Json joint = {{"node", node_of(one.joint)}};
      if (i < chain.turning_joints()) {
        const Point3& g = one.gravity;
        const Point3 gravity = {turn_[0] * g[0] + turn_[1] * g[1] + turn_[2] * g[2],
                                turn_[3] * g[0] + turn_[4] * g[1] + turn_[5] * g[2],
                                turn_[6] * g[0] + turn_[7] * g[1] + turn_[8] * g[2]};
        joint["hitRadius"] = one.hit_radius;
        joint["stiffness"] = one.stiffness;
        joint["gravityPower"] = one.gravity_power;
        joint["gravityDir"] = gravity;
        joint["dragForce"] = one.drag;
        set_limit(chain, i, &joint);
      }
      joints.push_back(std::move(joint));
    }
    if (chain.end) joints.push_back({{"node", end_node(chain.joints.back().joint, *chain.end)}});
    Json out = {{"joints", std::move(joints)}};
    if (!chain.name.empty()) out["name"] = chain.name;
    for (const size_t group : chain.groups) out["colliderGroups"].push_back(groups[group]);
    if (chain.center >= 0) out["center"] = node_of(static_cast<size_t>(chain.center));
    return out;
  }

  const GltfJoints& joints_;
  const Rotation& turn_;
  Json& document_;
  std::vector<Affine> back_;  // [J] from the world to the joint
  bool extended_ = false, limited_ = false;
};

void use_extension(const char* name, Json* document) {
  Json& used = (*document)["extensionsUsed"];
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

}  // namespace

void write_springs(const Springs& springs, const GltfJoints& joints, const Rotation& turn, Json* document) {
  const auto is_old = [](const auto& one) { return one.source >= 0; };
  const bool knows_document = std::any_of(springs.chains.begin(), springs.chains.end(), is_old) ||
                              std::any_of(springs.groups.begin(), springs.groups.end(), is_old);
  const Json::json_pointer at("/extensions/VRMC_springBone");
  const Json before = knows_document && document->contains(at) ? (*document)[at] : Json();
  drop_extension("VRMC_springBone", document);
  if (before.is_null()) drop_extension("VRMC_springBone_extended_collider", document);
  // Those of VRM 0.x would be played as well.
  if (const Json::json_pointer older("/extensions/VRM/secondaryAnimation"); document->contains(older))
    (*document)[older] = {{"boneGroups", Json::array()}, {"colliderGroups", Json::array()}};
  if (springs.chains.empty()) return;
  SpringWriter writer(joints, turn, document);
  Json made = writer.write(springs, before);
  (*document)["extensions"]["VRMC_springBone"] = std::move(made);
  use_extension("VRMC_springBone", document);
  if (writer.extended()) use_extension("VRMC_springBone_extended_collider", document);
  if (writer.limited()) use_extension(kSpringLimit, document);
}

}  // namespace sinew
