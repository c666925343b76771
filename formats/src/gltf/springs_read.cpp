// SPDX-License-Identifier: MIT
// VRMC_springBone 1.0 with VRMC_springBone_extended_collider 1.0 (github.com/vrm-c/vrm-specification), and the
// equivalent of VRM 0.x, as Springs.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "gltf/gltf_source.hpp"
#include "gltf/spring_limits.hpp"
#include "gltf/vrm.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/springs.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr const char* kSprings = "VRMC_springBone";
constexpr const char* kExtended = "VRMC_springBone_extended_collider";
constexpr double kAny = std::numeric_limits<double>::infinity();

class SpringReader {
 public:
  SpringReader(const std::string& path, const GltfSource& source, const Json& document)
      : path_(path),
        source_(source),
        nodes_(document["nodes"]),
        parents_(nodes_.size(), -1),
        joint_of_(nodes_.size(), -1) {
    for (size_t n = 0; n < nodes_.size(); ++n)
      for (const Json& child : nodes_[n].value("children", Json::array()))
        if (child.get<size_t>() < nodes_.size()) parents_[child.get<size_t>()] = static_cast<int>(n);
    for (size_t j = 0; j < source.joint_nodes.size(); ++j)
      joint_of_[static_cast<size_t>(source.joint_nodes[j])] = static_cast<int>(j);
  }

  Springs read(const Json& extension) {
    const Json& colliders = list(extension, "colliders", "extension");
    for (size_t c = 0; c < colliders.size(); ++c) read_collider("colliders[" + std::to_string(c) + "]", colliders[c]);
    const Json& groups = list(extension, "colliderGroups", "extension");
    for (size_t g = 0; g < groups.size(); ++g) {
      const std::string where = "colliderGroups[" + std::to_string(g) + "]";
      ColliderGroup group = {text(groups[g], "name"), {}, static_cast<int>(g)};
      for (const Json& one : list(groups[g], "colliders", where)) {
        const int number = new_collider_.at(index(where + ".colliders", one, colliders.size(), "collider"));
        if (number >= 0) group.colliders.push_back(static_cast<size_t>(number));
      }
      out_.groups.push_back(std::move(group));
    }
    const Json& springs = list(extension, "springs", "extension");
    for (size_t s = 0; s < springs.size(); ++s) read_chain(static_cast<int>(s), springs[s]);
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& expected, const std::string& found) const {
    throw Error(path_ + ": extension " + kSprings + ", " + where + ": expected " + expected + ", found " + found);
  }
  static std::string text(const Json& object, const char* key) {
    return object.is_object() && object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
  }
  const Json& list(const Json& object, const char* key, const std::string& where) const {
    static const Json kNone = Json::array();
    if (!object.is_object()) fail(where, "an object", object.type_name());
    const auto found = object.find(key);
    if (found == object.end()) return kNone;
    if (!found->is_array()) fail(where + "." + key, "a list", found->type_name());
    return *found;
  }
  size_t index(const std::string& where, const Json& value, size_t count, const char* what) const {
    if (!value.is_number_unsigned() || value.get<uint64_t>() >= count)
      fail(where, std::string("a ") + what + " below " + std::to_string(count), one_line(value.dump()));
    return value.get<size_t>();
  }
  double number(const std::string& where, const Json& object, const char* key, double otherwise, double low,
                double high) const {
    if (!object.contains(key)) return otherwise;
    const Json& value = object[key];
    const double x = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (!(x >= low && x <= high) || !std::isfinite(x))
      fail(where + "." + key,
           low == -kAny ? "a number" : std::string("a number of 0 ") + (high == kAny ? "or more" : "to 1"),
           one_line(value.dump()));
    return x;
  }
  Point3 vector(const std::string& where, const Json& object, const char* key, const Point3& otherwise) const {
    if (!object.contains(key)) return otherwise;
    const Json& value = object[key];
    Point3 out = {};
    bool fine = value.is_array() && value.size() == 3;
    for (size_t c = 0; fine && c < 3; ++c) {
      fine = value[c].is_number();
      if (fine) out[c] = value[c].get<double>();
      fine = fine && std::isfinite(out[c]);
    }
    if (!fine) fail(where + "." + key, "three numbers", one_line(value.dump()));
    return out;
  }
  size_t node(const std::string& where, const Json& object) const {
    static const Json kNone;
    return index(where + ".node", object.is_object() && object.contains("node") ? object["node"] : kNone, nodes_.size(),
                 "node");
  }
  std::string node_name(size_t node) const {
    const std::string name = text(nodes_[node], "name");
    return name.empty() ? "node " + std::to_string(node) : in_quotes(name);
  }
  // The joint of a node, or of the nearest one above it.
  int joint_above(size_t node) const {
    for (int at = static_cast<int>(node); at >= 0; at = parents_[static_cast<size_t>(at)])
      if (joint_of_[static_cast<size_t>(at)] >= 0) return joint_of_[static_cast<size_t>(at)];
    return -1;
  }
  bool is_below(size_t node, size_t above) const {
    for (int at = parents_[node], steps = 0; at >= 0 && steps <= static_cast<int>(nodes_.size());
         at = parents_[static_cast<size_t>(at)], ++steps)
      if (static_cast<size_t>(at) == above) return true;
    return false;
  }
  // At rest. A node that was added for VRM 0.x has a translation alone.
  Affine world(size_t node) const {
    if (node < source_.bind_pose.worlds.size()) return source_.bind_pose.worlds[node];
    Affine own = kIdentity;
    const std::vector<double> at = nodes_[node].value("translation", std::vector<double>(3, 0.0));
    for (size_t c = 0; c < 3; ++c) own[4 * c + 3] = at.at(c);
    return parents_[node] < 0 ? own : multiply(world(static_cast<size_t>(parents_[node])), own);
  }
  Point3 joint_position(size_t joint) const {
    const Affine at = world(static_cast<size_t>(source_.joint_nodes[joint]));
    return {at[3], at[7], at[11]};
  }

  void read_collider(const std::string& where, const Json& object) {
    const size_t on = node(where, object);
    const Json* shapes = object.contains("shape") ? &object["shape"] : nullptr;
    if (const Json::json_pointer extended("/extensions/" + std::string(kExtended) + "/shape");
        object.contains(extended))
      shapes = &object[extended];
    SpringCollider made;
    made.name = text(object, "name");
    made.source = static_cast<int>(new_collider_.size());
    const Json* shape = nullptr;
    const char* kind = nullptr;
    for (const char* one : {"sphere", "capsule", "plane"})
      if (shapes != nullptr && shapes->is_object() && shapes->contains(one) && (*shapes)[one].is_object()) {
        shape = &(*shapes)[one];
        kind = one;
      }
    if (shape == nullptr) fail(where + ".shape", "a sphere or a capsule", "none");
    const std::string here = where + ".shape." + kind;
    const bool inside = shape->contains("inside") && (*shape)["inside"].is_boolean() && (*shape)["inside"].get<bool>();
    const bool capsule = std::string(kind) == "capsule", plane = std::string(kind) == "plane";
    made.shape = plane     ? ColliderShape::kPlane
                 : capsule ? (inside ? ColliderShape::kInsideCapsule : ColliderShape::kCapsule)
                           : (inside ? ColliderShape::kInsideSphere : ColliderShape::kSphere);
    const int joint = joint_above(on);
    new_collider_.push_back(joint < 0 ? -1 : static_cast<int>(out_.colliders.size()));
    const Point3 offset = vector(here, *shape, "offset", {}), tail = vector(here, *shape, "tail", {});
    const Point3 normal = vector(here, *shape, "normal", {0, 0, 1});
    made.radius = plane ? 0 : number(here, *shape, "radius", 0, 0, kAny);
    if (joint < 0) {
      out_.notes.push_back("collider on " + node_name(on) + " has no ancestor joint, so it was left out");
      return;
    }
    made.joint = static_cast<size_t>(joint);
    const Affine at = world(on);
    const auto from_joint = [&](const Point3& p) {
      return transform_point(at, p[0], p[1], p[2]) - joint_position(made.joint);
    };
    made.offset = from_joint(offset);
    if (capsule) made.tail = from_joint(tail);
    if (plane) made.tail = unit(transform_normal(at, normal[0], normal[1], normal[2]));
    out_.colliders.push_back(std::move(made));
  }

  static Point3 turned(Affine m, const Point3& v) {
    m[3] = m[7] = m[11] = 0;
    return transform_point(m, v[0], v[1], v[2]);
  }

  SpringJoint read_joint(const std::string& where, const Json& object) {
    SpringJoint joint;
    joint.hit_radius = number(where, object, "hitRadius", joint.hit_radius, 0, kAny);
    joint.stiffness = number(where, object, "stiffness", joint.stiffness, 0, kAny);
    joint.gravity_power = number(where, object, "gravityPower", joint.gravity_power, -kAny, kAny);
    joint.gravity = vector(where, object, "gravityDir", joint.gravity);
    const double drag = number(where, object, "dragForce", joint.drag, -kAny, kAny);
    joint.drag = std::clamp(drag, 0.0, 1.0);
    if (joint.drag != drag)
      out_.notes.push_back(where + ".dragForce is " + one_line(object["dragForce"].dump()) +
                           ", outside of 0 to 1; it is taken as " + (drag < 0 ? "0" : "1"));
    return joint;
  }

  // Limits of the joints that rotate, which need the chain's bones.
  void read_limits(const Json& joints, const std::string& called, SpringChain* chain) {
    size_t unknown = 0;
    for (size_t i = 0; i < chain->turning_joints(); ++i)
      for (const Json& object : joints) {
        SpringJoint& joint = chain->joints[i];
        const size_t at = object["node"].get<size_t>();
        const Json::json_pointer place("/extensions/" + std::string(kSpringLimit));
        if (joint_of_[at] != static_cast<int>(joint.joint) || !object.contains(place)) continue;
        const Affine world_of_node = world(at);
        const std::optional<Affine> back = inverse(world_of_node);
        if (!back) continue;
        const Point3 bone = tail_at_rest(*chain, i, source_.joints) - joint_position(joint.joint);
        const SpringLimit limit = read_spring_limit(object[place], turned(*back, bone));
        joint.limit = limit.limit;
        joint.hinge = unit(turned(world_of_node, limit.hinge));
        unknown += limit.known ? 0 : 1;
      }
    if (unknown > 0)
      out_.notes.push_back("chain " + called + " has " + std::to_string(unknown) +
                           " limits that are neither cones nor hinges; they stay in the file and are not played");
  }

  void read_chain(int number, const Json& object) {
    const std::string where = "springs[" + std::to_string(number) + "]";
    SpringChain chain;
    chain.source = number;
    chain.name = text(object, "name");
    const Json& joints = list(object, "joints", where);
    size_t left_out = 0;
    for (size_t i = 0; i < joints.size(); ++i) {
      const std::string here = where + ".joints[" + std::to_string(i) + "]";
      const size_t at = node(here, joints[i]);
      if (i > 0 && !is_below(at, joints[i - 1]["node"].get<size_t>())) {
        out_.notes.push_back(here + ": " + node_name(at) + " is not a descendant of " +
                             node_name(joints[i - 1]["node"].get<size_t>()) + "; the chain ends before it");
        break;
      }
      const int joint = joint_of_[at];
      if (joint >= 0) {
        chain.joints.push_back(read_joint(here, joints[i]));
        chain.joints.back().joint = static_cast<size_t>(joint);
      } else if (i + 1 == joints.size() && !chain.joints.empty()) {
        const Affine end = world(at);
        chain.end = Point3{end[3], end[7], end[11]} - joint_position(chain.joints.back().joint);
      } else {
        ++left_out;
      }
    }
    for (const Json& one : list(object, "colliderGroups", where))
      chain.groups.push_back(index(where + ".colliderGroups", one, out_.groups.size(), "collider group"));
    if (object.contains("center") && !object["center"].is_null())
      chain.center = joint_above(index(where + ".center", object["center"], nodes_.size(), "node"));
    if (chain.name.empty() && !chain.joints.empty()) chain.name = source_.joints[chain.joints[0].joint].name;
    const std::string called = chain.name.empty() ? where : in_quotes(chain.name);
    read_limits(joints, called, &chain);
    if (chain.turning_joints() == 0) {
      out_.notes.push_back("chain " + called + " has no joint with a skin that turns and is left out");
      return;
    }
    if (left_out > 0)
      out_.notes.push_back("chain " + called + " passes " + std::to_string(left_out) +
                           " nodes that are no joints; they keep their rest pose");
    out_.chains.push_back(std::move(chain));
  }

  const std::string& path_;
  const GltfSource& source_;
  const Json& nodes_;
  std::vector<int> parents_;       // [nodes] or -1
  std::vector<int> joint_of_;      // [nodes] or -1
  std::vector<int> new_collider_;  // [colliders of the file] or -1
  Springs out_;
};

void forget_sources(Springs* springs) {
  for (SpringCollider& one : springs->colliders) one.source = -1;
  for (ColliderGroup& one : springs->groups) one.source = -1;
  for (SpringChain& one : springs->chains) one.source = -1;
}

std::optional<Springs> springs_of_file(const std::string& path, const GltfSource& source) {
  const Json::json_pointer newer("/extensions/" + std::string(kSprings)), older("/extensions/VRM/secondaryAnimation");
  try {
    if (source.document.contains(newer))
      return SpringReader(path, source, source.document).read(source.document[newer]);
    if (!source.document.contains(older)) return std::nullopt;
    Json document = source.document;  // gets nodes at the ends of chains
    const Json springs = vrm_springs_of_zero(source.document[older], &document);
    if (springs.is_null()) return std::nullopt;
    Springs out = SpringReader(path, source, document).read(springs);
    // They are for a document rotated about y.
    for (SpringChain& chain : out.chains)
      for (SpringJoint& joint : chain.joints) joint.gravity = {-joint.gravity[0], joint.gravity[1], -joint.gravity[2]};
    forget_sources(&out);  // they are numbers of a document that nobody has
    return out;
  } catch (const Json::exception& error) {
    throw Error(
        path + ": " +
        (source.document.contains(newer) ? "extension " + std::string(kSprings) : "secondaryAnimation of VRM 0.x") +
        " is broken, and with it what swings; --replace finds springs anew: " + one_line(error.what()));
  }
}

// Only joints that have the same names in both.
Springs springs_by_name(const Springs& springs, const std::vector<Joint>& before, const std::vector<Joint>& joints) {
  std::map<std::string, int> numbers;
  for (size_t j = 0; j < joints.size(); ++j) numbers[joints[j].name] = static_cast<int>(j);
  std::vector<int> number;
  for (const Joint& joint : before) {
    const auto found = numbers.find(joint.name);
    number.push_back(found == numbers.end() ? -1 : found->second);
  }
  return springs_of_fewer(springs, before, number);
}

}  // namespace

std::optional<Springs> read_springs(const std::string& path, const Character& character) {
  if (!character.gltf) return std::nullopt;
  std::optional<Springs> springs = springs_of_file(path, *character.gltf);
  if (!springs || same_joints(character.joints, character.gltf->joints)) return springs;
  Springs left = springs_by_name(*springs, character.gltf->joints, character.joints);
  if (left.chains.empty()) return std::nullopt;
  return left;
}

Springs springs_of_fewer(const Springs& springs, const std::vector<Joint>& before, const std::vector<int>& number) {
  Springs out;
  out.groups = springs.groups;
  const auto above = [&](size_t joint) {  // itself, or the nearest one above that is left
    int at = static_cast<int>(joint);
    while (at >= 0 && number[static_cast<size_t>(at)] < 0) at = before[static_cast<size_t>(at)].parent;
    return at;
  };
  std::vector<int> new_collider(springs.colliders.size(), -1);
  for (size_t c = 0; c < springs.colliders.size(); ++c) {
    SpringCollider one = springs.colliders[c];
    const int at = above(one.joint);
    if (at < 0) {
      out.notes.push_back("a collider of " + before[one.joint].name + " is left out: no joint above it is left");
      continue;
    }
    const Point3 moved = point(before[one.joint].position) - point(before[static_cast<size_t>(at)].position);
    one.offset = one.offset + moved;
    if (one.shape != ColliderShape::kPlane) one.tail = one.tail + moved;
    one.joint = static_cast<size_t>(number[static_cast<size_t>(at)]);
    new_collider[c] = static_cast<int>(out.colliders.size());
    out.colliders.push_back(std::move(one));
  }
  for (ColliderGroup& group : out.groups) {
    std::vector<size_t> kept;
    for (const size_t c : group.colliders)
      if (new_collider[c] >= 0) kept.push_back(static_cast<size_t>(new_collider[c]));
    group.colliders = std::move(kept);
  }
  for (SpringChain chain : springs.chains) {
    std::vector<SpringJoint> kept;
    size_t last = before.size();  // the last joint that is left, by its old number
    for (SpringJoint joint : chain.joints) {
      if (number[joint.joint] < 0) continue;
      last = joint.joint;
      joint.joint = static_cast<size_t>(number[joint.joint]);
      kept.push_back(joint);
    }
    // Where the chain ended stays its end.
    if (!kept.empty() && last != chain.joints.back().joint) {
      const size_t old_last = chain.joints.back().joint;
      const Point3 to_end = point(before[old_last].position) - point(before[last].position);
      chain.end = to_end + chain.end.value_or(Point3{});
    }
    chain.joints = std::move(kept);
    if (chain.center >= 0) {
      const int at = above(static_cast<size_t>(chain.center));
      chain.center = at < 0 ? -1 : number[static_cast<size_t>(at)];
    }
    if (chain.turning_joints() == 0)
      out.notes.push_back("chain " + in_quotes(chain.name) + " is left out: its joints are gone");
    else
      out.chains.push_back(std::move(chain));
  }
  forget_sources(&out);
  return out;
}

}  // namespace sinew
