// SPDX-License-Identifier: MIT
// From a character's own joints to its target skeleton, in the steps of the header.
#include "sinew_data_sets/target_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "names/joint_name.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/vertex_areas.hpp"

namespace sinew {
namespace {

using namespace rigging;

constexpr double kBound = 0.002;          // of the vertices or of the surface
constexpr double kMergeDistance = 0.01;   // of the side, as are the next two
constexpr double kPelvisDistance = 0.08;  // two pelvises nearer than that are one
constexpr double kShortestEnd = 0.01;
constexpr double kEndShare = 0.85, kEndQuantile = 0.98;

// Linear between the two nearest, as numpy's. `values` holds at least one.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = static_cast<double>(values.size() - 1) * share;
  const auto below = static_cast<size_t>(at);
  const double a = values[below], b = values[std::min(below + 1, values.size() - 1)];
  const double t = at - static_cast<double>(below);
  return t < 0.5 ? a + (b - a) * t : b - (b - a) * (1 - t);
}

double longest_side(const std::vector<Vec3>& vertices) {
  Point3 low = point(vertices[0]), high = low;
  for (const Vec3& v : vertices) {
    const Point3 p = point(v);
    for (size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

void check(const Character& c) {
  const std::string name = c.name.empty() ? "the character" : c.name;
  if (c.joints.empty()) throw Error(name + ": has no joints for a reference skeleton");
  if (c.vertices.empty() || c.influences.size() != c.vertices.size())
    throw Error(name + ": has no weights, expected a bound character");
  for (const Joint& joint : c.joints)
    if (joint.parent >= static_cast<int>(c.joints.size()))
      throw Error(name + ": the joint " + joint.name + " has a parent that does not exist");
  for (const auto& row : c.influences)
    for (const Influence& influence : row)
      if (influence.joint >= c.joints.size())
        throw Error(name + ": a vertex is bound to joint " + std::to_string(influence.joint) + " of " +
                    std::to_string(c.joints.size()));
  for (const uint32_t v : c.face_vertices)
    if (v >= c.vertices.size())
      throw Error(name + ": a face has vertex " + std::to_string(v) + " of " + std::to_string(c.vertices.size()));
}

// Joints of the character throughout; arrays are [J].
class TargetMaker {
 public:
  explicit TargetMaker(const Character& c)
      : c_(c), side_(longest_side(c.vertices)), areas_(vertex_areas(c)), children_(c.joints.size()) {
    total_area_ = std::accumulate(areas_.begin(), areas_.end(), 0.0);
    for (const Joint& joint : c.joints) {
      file_parents_.push_back(joint.parent < 0 ? -1 : joint.parent);
      positions_.push_back(point(joint.position));
    }
    if (!(side_ > 0)) throw Error(c.name + ": its vertices are all at one position");
    sort_joints();
  }

  TargetSkeleton make() {
    weigh();
    classify();
    find_bound();
    choose_parents();
    drop_unbound_roots();
    while (merge_near_joints()) {
    }
    find_owners();
    add_joints();
    add_ends();
    return std::move(out_);
  }

 private:
  size_t count() const { return c_.joints.size(); }
  std::vector<int> alive() const {
    std::vector<int> joints;
    for (size_t j = 0; j < count(); ++j)
      if (alive_[j]) joints.push_back(static_cast<int>(j));
    return joints;
  }
  static size_t at(int joint) { return static_cast<size_t>(joint); }

  // Parents first, children in the file's order.
  void sort_joints() {
    std::vector<int> open;
    for (size_t j = 0; j < count(); ++j) {
      if (file_parents_[j] >= 0)
        children_[at(file_parents_[j])].push_back(static_cast<int>(j));
      else
        open.push_back(static_cast<int>(j));
    }
    std::reverse(open.begin(), open.end());
    while (!open.empty()) {
      const int j = open.back();
      open.pop_back();
      order_.push_back(j);
      open.insert(open.end(), children_[at(j)].rbegin(), children_[at(j)].rend());
    }
    if (order_.size() != count()) throw Error(c_.name + ": its joints form a cycle, expected a tree");
  }

  // Shares of vertices and surface by weight.
  void weigh() {
    own_vertices_.assign(count(), 0);
    own_surface_.assign(count(), 0);
    for (size_t v = 0; v < c_.vertices.size(); ++v) {
      for (const Influence& i : c_.influences[v]) {
        own_vertices_[i.joint] += static_cast<double>(i.weight);
        own_surface_[i.joint] += static_cast<double>(i.weight) * areas_[v];
      }
    }
    for (double& share : own_vertices_) share /= static_cast<double>(c_.vertices.size());
    for (double& share : own_surface_) share /= std::max(total_area_, 1e-12);
  }

  bool has_weight(int j) const { return own_vertices_[at(j)] > 0; }

  void classify() {
    classes_.assign(count(), kClassOther);
    hosts_.resize(count());
    std::iota(hosts_.begin(), hosts_.end(), 0);
    const JointVerdicts by_weight = joint_verdicts(c_.joints, follows_of(c_)), by_name = joint_verdicts(c_.joints);
    for (const int j : order_) {
      // Only the name decides whether a leaf without weight is a detail.
      bool detail = (by_weight.is_end(at(j)) ? by_name : by_weight).roles[at(j)] > SINEW_ROLE_END ||
                    (by_weight.is_end(at(j)) && by_name.is_end(at(j)) && file_parents_[at(j)] >= 0 &&
                     hosts_[at(file_parents_[at(j)])] != file_parents_[at(j)]);
      const uint8_t joint_class = by_weight.classes[at(j)];
      detail = detail || joint_class >= SINEW_CLASS_THUMB;  // a jaw's control as well
      if (!detail && joint_class < kJointClasses) classes_[at(j)] = static_cast<JointClass>(joint_class);
      if (detail && file_parents_[at(j)] >= 0) hosts_[at(j)] = hosts_[at(file_parents_[at(j)])];
    }
  }

  void find_bound() {
    vertices_.assign(count(), 0);
    surface_.assign(count(), 0);
    for (size_t j = 0; j < count(); ++j) {
      vertices_[at(hosts_[j])] += own_vertices_[j];
      surface_[at(hosts_[j])] += own_surface_[j];
    }
    for (size_t j = 0; j < count(); ++j) bound_.push_back(vertices_[j] >= kBound || surface_[j] >= kBound);
    if (std::find(bound_.begin(), bound_.end(), true) == bound_.end())
      bound_[static_cast<size_t>(std::max_element(vertices_.begin(), vertices_.end()) - vertices_.begin())] = true;
  }

  void choose_parents() {
    std::vector<bool> leads_to_bound = bound_;
    surface_below_.assign(count(), 0);
    for (size_t j = 0; j < count(); ++j) surface_below_[j] = bound_[j] ? surface_[j] : 0;
    for (auto j = order_.rbegin(); j != order_.rend(); ++j) {
      const int parent = file_parents_[at(*j)];
      if (parent < 0) continue;
      leads_to_bound[at(parent)] = leads_to_bound[at(parent)] || leads_to_bound[at(*j)];
      surface_below_[at(parent)] += surface_below_[at(*j)];
    }
    alive_.resize(count());
    for (size_t j = 0; j < count(); ++j) alive_[j] = leads_to_bound[j] && hosts_[j] == static_cast<int>(j);
    parents_.assign(count(), -1);
    for (const int j : order_) {
      if (!alive_[at(j)]) continue;
      int parent = file_parents_[at(j)];
      while (parent >= 0 && !alive_[at(parent)]) parent = file_parents_[at(parent)];
      parents_[at(j)] = parent;
    }
  }

  std::vector<int> alive_children(int parent) const {
    std::vector<int> found;
    for (const int j : alive())
      if (parents_[at(j)] == parent) found.push_back(j);
    return found;
  }

  // One root in the end; its former siblings become children of the nearest joint below it.
  void drop_unbound_roots() {
    while (true) {
      std::vector<int> tops = alive_children(-1);
      if (tops.size() == 1) {
        const int top = tops[0];
        const std::vector<int> below = alive_children(top);
        if (bound_[at(top)] || below.empty()) return;
        alive_[at(top)] = false;
        for (const int child : below) parents_[at(child)] = -1;
        if (below.size() == 1) continue;
        tops = below;
      }
      const int root = *std::max_element(tops.begin(), tops.end(), [&](int a, int b) {
        return surface_below_[at(a)] < surface_below_[at(b)];  // the first of equals
      });
      const std::vector<int> body = with_all_below(root);
      for (const int top : tops)
        if (top != root) parents_[at(top)] = nearest(body, positions_[at(top)]);
      if (bound_[at(root)]) return;
    }
  }

  std::vector<int> with_all_below(int root) const {
    std::set<int> inside = {root};
    std::vector<int> open = {root};
    while (!open.empty()) {
      const int parent = open.back();
      open.pop_back();
      for (const int child : alive_children(parent))
        if (inside.insert(child).second) open.push_back(child);
    }
    return {inside.begin(), inside.end()};
  }

  int nearest(const std::vector<int>& joints, const Point3& position) const {
    int best = joints[0];
    double least = INFINITY;
    for (const int j : joints) {
      const double distance = length(positions_[at(j)] - position);
      if (distance < least) {
        least = distance;
        best = j;
      }
    }
    return best;
  }

  // One pass from the roots down; false when there was nothing to merge.
  bool merge_near_joints() {
    if (sources_.empty()) {
      sources_.resize(count());
      std::iota(sources_.begin(), sources_.end(), 0);
      merged_into_ = sources_;
    }
    bool changed = false;
    for (const int j : order_) {
      const int parent = parents_[at(j)];
      if (!alive_[at(j)] || parent < 0) continue;
      const double distance = length(positions_[at(sources_[at(j)])] - positions_[at(sources_[at(parent)])]);
      const bool pelvises = classes_[at(j)] == kClassPelvis && classes_[at(parent)] == kClassPelvis;
      if (distance >= kMergeDistance * side_ && !(pelvises && distance < kPelvisDistance * side_)) continue;
      merge(j, parent);
      changed = true;
    }
    return changed;
  }

  void merge(int child, int parent) {
    const size_t j = at(child), p = at(parent);
    if (surface_[j] > surface_[p] || !bound_[p]) sources_[p] = sources_[j];
    if (!bound_[p] || classes_[p] == kClassOther) classes_[p] = classes_[j];
    surface_[p] += surface_[j];
    bound_[p] = bound_[p] || bound_[j];
    alive_[j] = false;
    merged_into_[j] = parent;
    for (const int other : alive_children(child)) parents_[at(other)] = parent;
  }

  int survivor(int j) const {
    while (merged_into_[at(j)] != j) j = merged_into_[at(j)];
    return j;
  }

  // The remaining joint for a joint, else for the nearest joint above it, else the joint nearest to it.
  void find_owners() {
    const std::vector<int> left = alive();
    std::map<int, uint32_t> index;
    for (const int j : left) index.emplace(j, static_cast<uint32_t>(index.size()));
    out_.owners.resize(count());
    for (const int j : order_) {
      int owner = survivor(hosts_[at(j)]);
      while (owner >= 0 && !alive_[at(owner)]) {
        owner = file_parents_[at(owner)];
        if (owner >= 0) owner = survivor(hosts_[at(owner)]);
      }
      out_.owners[at(j)] = index.at(owner >= 0 ? owner : nearest(left, positions_[at(j)]));
    }
    for (const int j : left) {
      TargetJoint joint;
      joint.name = c_.joints[at(j)].name;
      joint.source = static_cast<uint32_t>(sources_[at(j)]);
      joint.position = positions_[at(sources_[at(j)])];
      joint.parent = parents_[at(j)] < 0 ? -1 : static_cast<int>(index.at(parents_[at(j)]));
      joint.joint_class = classes_[at(j)];
      out_.joints.push_back(std::move(joint));
    }
    out_.side = side_;
  }

  // Weights of vertices by target joint, and the mass of each.
  void add_joints() {
    vertex_weights_.resize(c_.vertices.size());
    for (size_t v = 0; v < c_.vertices.size(); ++v) {
      auto& row = vertex_weights_[v];
      for (const Influence& i : c_.influences[v]) {
        const uint32_t owner = out_.owners[i.joint];
        const auto found =
            std::find_if(row.begin(), row.end(), [&](const Influence& one) { return one.joint == owner; });
        if (found == row.end())
          row.push_back({owner, i.weight});
        else
          found->weight += i.weight;
      }
      for (const Influence& i : row)
        if (total_area_ > 0) out_.joints[i.joint].mass += static_cast<double>(i.weight) * areas_[v] / total_area_;
    }
  }

  void add_ends() {
    const size_t joints = out_.joints.size();
    std::vector<bool> leaf(joints, true);
    for (const TargetJoint& joint : out_.joints)
      if (joint.parent >= 0) leaf[static_cast<size_t>(joint.parent)] = false;
    for (size_t i = 0; i < joints; ++i) {
      if (!leaf[i]) continue;
      std::optional<Point3> end = end_in_file(static_cast<int>(out_.joints[i].source));
      if (!end) end = end_of_vertices(static_cast<uint32_t>(i));
      if (!end) continue;
      TargetJoint tip = out_.joints[i];
      tip.name += "_end";
      tip.position = *end;
      tip.parent = static_cast<int>(i);
      tip.tip = true;
      tip.mass = 0;
      out_.joints.push_back(std::move(tip));
    }
  }

  // The only weightless leaf below a joint: one without a name to speak of or of another host counts where it is
  // called an end.
  std::optional<Point3> end_in_file(int joint) const {
    std::optional<Point3> end;
    for (const int child : children_[at(joint)]) {
      if (has_weight(child) || !children_[at(child)].empty()) continue;
      const names::JointName name = names::read_joint_name(c_.joints[at(child)].name.c_str());
      const bool same_host = name.words > 0 && hosts_[at(child)] == hosts_[at(joint)];
      if (!same_host && !name.has(names::kEnd | names::kNub | names::kTip)) continue;
      if (length(positions_[at(child)] - positions_[at(joint)]) <= kShortestEnd * side_) continue;
      if (end) return std::nullopt;
      end = positions_[at(child)];
    }
    return end;
  }

  std::optional<Point3> end_of_vertices(uint32_t joint) const {
    const Point3& start = out_.joints[joint].position;
    for (const float least : {0.5f, 0.2f}) {
      std::vector<Point3> offsets;
      Point3 sum{};
      for (size_t v = 0; v < c_.vertices.size(); ++v) {
        for (const Influence& i : vertex_weights_[v]) {
          if (i.joint != joint || !(i.weight > least)) continue;
          offsets.push_back(point(c_.vertices[v]) - start);
          for (size_t k = 0; k < 3; ++k) sum[k] += offsets.back()[k] * (static_cast<double>(i.weight) * areas_[v]);
        }
      }
      if (offsets.empty()) continue;
      const double norm = length(sum);
      if (norm < 1e-9) return std::nullopt;
      std::vector<double> along;
      for (double& one : sum) one /= norm;
      for (const Point3& offset : offsets) along.push_back(dot(offset, sum));
      const double reach = quantile(std::move(along), kEndQuantile);
      if (reach <= kShortestEnd * side_) return std::nullopt;
      return Point3{start[0] + sum[0] * kEndShare * reach, start[1] + sum[1] * kEndShare * reach,
                    start[2] + sum[2] * kEndShare * reach};
    }
    return std::nullopt;
  }

  const Character& c_;
  double side_ = 0, total_area_ = 0;
  std::vector<double> areas_;               // [V]
  std::vector<std::vector<int>> children_;  // of the file, like these three
  std::vector<int> file_parents_, order_;
  std::vector<Point3> positions_;
  std::vector<double> own_vertices_, own_surface_;  // shares by weight
  std::vector<JointClass> classes_;
  std::vector<int> hosts_;                  // the joint that has a detail's weight; itself for all others
  std::vector<double> vertices_, surface_;  // shares with those of details
  std::vector<bool> bound_, alive_;
  std::vector<double> surface_below_;
  std::vector<int> parents_;                            // among those alive
  std::vector<int> sources_, merged_into_;              // whose position a joint has; where it went, itself if nowhere
  std::vector<std::vector<Influence>> vertex_weights_;  // [V] on target joints
  TargetSkeleton out_;
};

}  // namespace

TargetSkeleton target_skeleton(const Character& character) {
  check(character);
  return TargetMaker(character).make();
}

std::vector<Joint> target_joints(const TargetSkeleton& target) {
  std::vector<bool> leaf(target.joints.size(), true);
  for (const TargetJoint& joint : target.joints)
    if (joint.parent >= 0) leaf[static_cast<size_t>(joint.parent)] = false;
  std::vector<Joint> joints;
  std::set<std::string> names;
  for (size_t i = 0; i < target.joints.size(); ++i) {
    const TargetJoint& from = target.joints[i];
    const std::string base = !from.tip && leaf[i] && names_bone_end(from.name) ? from.name + "_joint" : from.name;
    Joint joint;
    joint.name = base;
    for (int number = 1; !names.insert(joint.name).second; ++number) joint.name = base + std::to_string(number);
    joint.position = {static_cast<float>(from.position[0]), static_cast<float>(from.position[1]),
                      static_cast<float>(from.position[2])};
    joint.parent = from.parent;
    joints.push_back(std::move(joint));
  }
  return joints;
}

}  // namespace sinew
