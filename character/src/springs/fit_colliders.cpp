// SPDX-License-Identifier: MIT
// Parts of a body by classes of joints, a shape for each, and which chain reaches which.
#include "sinew_character/springs/fit_colliders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/median.hpp"
#include "springs/body_skin.hpp"

namespace sinew {
namespace {

constexpr size_t kFewPoints = 8;      // fewer say nothing about a shape
constexpr size_t kMostPoints = 2000;  // of a part
constexpr double kLowShare = 0.05;    // of a part's points on either side its length leaves out
constexpr double kAcross = 1.2;       // radii that a shape is long at least
constexpr double kShrink = 0.75;      // of its radius a shape keeps at least
constexpr double kTouch = 0.98;       // of the distance at rest a radius is
constexpr double kReach = 1.1;        // lengths of a chain within which it meets what moves little
constexpr double kLimbReach = 0.5;    // lengths of a limb more, since limbs move

// Parts in the order in which they are named; sides double those behind the hips.
struct Part {
  const char* name;
  bool sided;
};
enum PartNumber { kHead, kNeck, kChest, kBelly, kHips, kUpperArm, kForearm, kHand, kThigh, kCalf, kPartCount };
constexpr std::array<Part, kPartCount> kPartTable = {{{"head", false},
                                                      {"neck", false},
                                                      {"chest", false},
                                                      {"belly", false},
                                                      {"hips", false},
                                                      {"upper arm", true},
                                                      {"forearm", true},
                                                      {"hand", true},
                                                      {"thigh", true},
                                                      {"calf", true}}};

struct Shape {
  Point3 a = {}, b = {};
  double radius = 0, error = 0;
  bool fits = true;  // it is not laid across what is long
};

double shape_error(const std::vector<Point3>& points, const Shape& shape) {
  double sum = 0;
  for (const Point3& p : points) sum += std::abs(segment_distance(p, shape.a, shape.b) - shape.radius);
  return shape.radius > 0 ? sum / (static_cast<double>(points.size()) * shape.radius) : 1e9;
}

// A capsule along a direction through the points' middle; a sphere where they are no longer than wide.
Shape capsule_along(const std::vector<Point3>& points, const Point3& middle, const Point3& direction) {
  std::vector<double> along, across_it;
  for (const Point3& p : points) along.push_back(dot(p - middle, direction));
  std::vector<double> sorted = along;
  std::sort(sorted.begin(), sorted.end());
  const size_t cut = static_cast<size_t>(kLowShare * static_cast<double>(sorted.size()));
  const double low = sorted[cut], high = sorted[sorted.size() - 1 - cut];
  for (size_t i = 0; i < points.size(); ++i)
    if (along[i] >= low && along[i] <= high) across_it.push_back(length(across(points[i] - middle, direction)));
  Shape shape;
  shape.radius = median(&across_it);
  if (high - low > 2 * shape.radius) {
    shape.a = middle + (low + shape.radius) * direction;
    shape.b = middle + (high - shape.radius) * direction;
  } else {
    shape.a = shape.b = middle + (0.5 * (low + high)) * direction;
    std::vector<double> distances;
    for (const Point3& p : points) distances.push_back(length(p - shape.a));
    shape.radius = median(&distances);
  }
  shape.error = shape_error(points, shape);
  shape.fits = high - low > kAcross * shape.radius;
  return shape;
}

Shape fit_shape(const std::vector<Point3>& points, const Point3& bone) {
  Point3 middle{};
  for (const Point3& p : points) middle = middle + p;
  middle = (1.0 / static_cast<double>(points.size())) * middle;
  Shape best = capsule_along(points, middle, unit(bone));
  for (const Point3& axis : {Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) {
    const Shape other = capsule_along(points, middle, axis);
    // In lengths: shares of a radius would speak for large shapes. Along its bone where that is about as good.
    if (best.fits && !other.fits) continue;
    if (other.fits != best.fits || other.error * other.radius < 0.95 * best.error * best.radius) best = other;
  }
  return best;
}

class BodyFitter {
 public:
  BodyFitter(const Character& character, const std::vector<FoundChain>& chains)
      : c_(character),
        verdicts_(joint_verdicts(character.joints, follows_of(character))),
        tree_(character.joints),
        held_(held_vertices(character)) {
    classes_ = verdicts_.classes;
    if (std::none_of(classes_.begin(), classes_.end(), [](uint8_t c) { return c == SINEW_CLASS_THIGH; }))
      classes_ = limb_classes(map_rig_of(character), character.up);
    swings_.assign(c_.joints.size(), 0);
    for (const FoundChain& chain : chains)
      for (const SpringJoint& joint : chain.chain.joints) swings_[joint.joint] = 1;
    find_parts();
  }

  BodyColliders fit() const {
    BodyColliders out;
    for (int side = 0; side < 3; ++side)
      for (int part = 0; part < kPartCount; ++part)
        if (out.colliders.size() < kMostColliders) fit_part(part, side, &out);
    return out;
  }

 private:
  static int key(int part, int side) { return 3 * part + side; }

  int part_of_class(size_t j) const {
    switch (classes_[j]) {
      case SINEW_CLASS_HEAD:
      case SINEW_CLASS_EYE:
      case SINEW_CLASS_JAW:
        return kHead;
      case SINEW_CLASS_NECK:
        return kNeck;
      case SINEW_CLASS_SPINE:
        return spine_part(j);
      case SINEW_CLASS_CLAVICLE:
        return kChest;
      case SINEW_CLASS_PELVIS:
      case SINEW_CLASS_HIP:
        return kHips;
      case SINEW_CLASS_UPPER_ARM:
        return kUpperArm;
      case SINEW_CLASS_FOREARM:
        return kForearm;
      case SINEW_CLASS_HAND:
        return kHand;
      case SINEW_CLASS_THIGH:
        return kThigh;
      case SINEW_CLASS_CALF:
        return kCalf;
      case SINEW_CLASS_FOOT:
      case SINEW_CLASS_TOE:
      case SINEW_CLASS_WING:
      case SINEW_CLASS_PROP:
        return kPartCount;  // none
      default:
        return -1;  // that of the joint above
    }
  }
  // The lower half of the spine's joints is the belly; a lone one is the chest.
  int spine_part(size_t joint) const {
    size_t above = 0, below = 0;
    for (int at = c_.joints[joint].parent; at >= 0; at = c_.joints[joint_index(at)].parent)
      above += classes_[joint_index(at)] == SINEW_CLASS_SPINE ? 1 : 0;
    size_t at = joint;
    for (bool more = true; more;) {
      more = false;
      for (const int child : tree_.children[at])
        if (classes_[joint_index(child)] == SINEW_CLASS_SPINE && swings_[joint_index(child)] == 0) {
          ++below;
          at = joint_index(child);
          more = true;
          break;
        }
    }
    return above < below ? kBelly : kChest;
  }
  int side_of(size_t j) const {
    if (verdicts_.sides[j] != 0) return verdicts_.sides[j] > 0 ? 1 : 2;
    return c_.joints[j].position.x > 0 ? 1 : 2;
  }

  void find_parts() {
    std::vector<int> keys(c_.joints.size(), -1);
    for (const size_t j : tree_.parents_first) {
      const int parent = c_.joints[j].parent;
      if (swings_[j] != 0) continue;  // and its descendants
      if (parent >= 0 && (swings_[joint_index(parent)] != 0 || keys[joint_index(parent)] == -2)) {
        keys[j] = -2;
        continue;
      }
      const int part = part_of_class(j);
      if (part == kPartCount) continue;
      keys[j] = part < 0 ? (parent < 0 ? -1 : keys[joint_index(parent)])
                         : key(part, kPartTable[static_cast<size_t>(part)].sided ? side_of(j) : 0);
      if (keys[j] < 0) continue;
      joints_[keys[j]].push_back(j);
    }
  }

  void fit_part(int part, int side, BodyColliders* out) const {
    const auto found = joints_.find(key(part, side));
    if (found == joints_.end()) return;
    std::vector<Point3> points;
    for (const size_t j : found->second)
      for (const uint32_t v : held_[j]) points.push_back(point(c_.vertices[v]));
    if (points.size() < kFewPoints) return;
    if (points.size() > kMostPoints) {
      std::vector<Point3> fewer;
      for (size_t i = 0; i < kMostPoints; ++i) fewer.push_back(points[i * points.size() / kMostPoints]);
      points = std::move(fewer);
    }
    const size_t first = found->second[0];
    Point3 bone = up_of(c_);
    for (const int child : tree_.children[first])
      if (swings_[joint_index(child)] == 0 &&
          length(point(c_.joints[joint_index(child)].position) - point(c_.joints[first].position)) > 0)
        bone = point(c_.joints[joint_index(child)].position) - point(c_.joints[first].position);
    const Shape shape = fit_shape(points, bone);
    if (!(shape.radius > 0)) return;
    SpringCollider collider;
    const Part& one = kPartTable[static_cast<size_t>(part)];
    collider.name = side == 0 ? one.name : (side == 1 ? "left " : "right ") + std::string(one.name);
    collider.joint = first;
    const Point3 origin = point(c_.joints[first].position);
    collider.offset = shape.a - origin;
    collider.tail = shape.b - origin;
    collider.radius = shape.radius;
    collider.shape = length(shape.b - shape.a) > 0 ? ColliderShape::kCapsule : ColliderShape::kSphere;
    if (collider.shape == ColliderShape::kSphere) collider.tail = {};
    out->colliders.push_back(std::move(collider));
    out->errors.push_back(shape.error);
  }

  const Character& c_;
  const JointVerdicts verdicts_;
  const JointTree tree_;
  const std::vector<std::vector<uint32_t>> held_;
  std::vector<uint8_t> classes_, swings_;      // [J]
  std::map<int, std::vector<size_t>> joints_;  // by part and side, parents first
};

double distance_to(const SpringCollider& c, const Character& character, const Point3& p) {
  const Point3 origin = point(character.joints[c.joint].position);
  const Point3 end = c.shape == ColliderShape::kCapsule ? c.tail : c.offset;
  return segment_distance(p, origin + c.offset, origin + end);
}

// The ends of a chain's bones at rest.
std::vector<Point3> tails_of(const SpringChain& chain, const Character& character) {
  std::vector<Point3> tails;
  for (size_t i = 0; i < chain.turning_joints(); ++i) tails.push_back(tail_at_rest(chain, i, character.joints));
  return tails;
}

bool within_reach(const SpringCollider& c, const Character& character, const FoundChain& found) {
  if (found.kind == SpringKind::kBust || (found.kind == SpringKind::kEar && c.name != "head")) return false;
  const Point3 start = point(character.joints[found.chain.joints[0].joint].position);
  const bool limb = c.name.rfind("left ", 0) == 0 || c.name.rfind("right ", 0) == 0;
  const double own = length(c.tail - c.offset) + 2 * c.radius;
  return distance_to(c, character, start) - c.radius < kReach * found.length + (limb ? kLimbReach * own : 0);
}

}  // namespace

BodyColliders fit_colliders(const Character& character, const std::vector<FoundChain>& chains) {
  return BodyFitter(character, chains).fit();
}

void assign_colliders(const Character& character, const BodyColliders& body, std::vector<FoundChain>* chains,
                      Springs* springs, std::vector<double>* errors) {
  std::vector<SpringCollider> shapes = body.colliders;
  std::vector<std::set<size_t>> users(shapes.size());  // numbers of chains
  for (size_t s = 0; s < shapes.size(); ++s) {
    SpringCollider& shape = shapes[s];
    const double least = kShrink * shape.radius;
    for (size_t n = 0; n < chains->size(); ++n) {
      FoundChain& found = (*chains)[n];
      if (!found.kept || found.own || !within_reach(shape, character, found)) continue;
      const std::vector<Point3> tails = tails_of(found.chain, character);
      double nearest = shape.radius / kTouch;
      for (const Point3& tail : tails) nearest = std::min(nearest, distance_to(shape, character, tail));
      if (kTouch * nearest < least) continue;  // it begins inside
      shape.radius = std::min(shape.radius, kTouch * nearest);
      users[s].insert(n);
    }
  }
  for (size_t s = 0; s < shapes.size(); ++s) {
    if (users[s].empty()) continue;
    const size_t group = springs->groups.size();
    springs->groups.push_back({shapes[s].name, {springs->colliders.size()}});
    springs->colliders.push_back(shapes[s]);
    if (errors != nullptr) errors->push_back(body.errors[s]);
    for (const size_t n : users[s]) {
      SpringChain& chain = (*chains)[n].chain;
      chain.groups.push_back(group);
      const std::vector<Point3> tails = tails_of(chain, character);
      for (size_t i = 0; i < tails.size(); ++i) {
        const double room = distance_to(shapes[s], character, tails[i]) - shapes[s].radius;
        chain.joints[i].hit_radius = std::max(0.0, std::min(chain.joints[i].hit_radius, kTouch * room));
      }
    }
  }
}

}  // namespace sinew
