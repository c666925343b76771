// SPDX-License-Identifier: MIT
// A tree of parts by their boxes, and names by where they are.
#include "sinew_character/predict/part_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "predict/part_box.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

// Shares of the longest side.
constexpr double kTouch = 0.02;    // between parts that touch
constexpr double kFarthest = 0.1;  // between a part and its parent
constexpr double kSmall = 0.08;    // a part that goes with another
constexpr double kOnGround = 0.06;
constexpr double kWithin = 0.7;  // of a part's box inside another's: it goes with that
constexpr double kLying = 1.3;   // a torso that is so many times as long as high
constexpr size_t kFewestMoving = 4;
constexpr size_t kMostParts = 300;  // more are a soup, or feathers

struct SolidPart {
  PartBox box;
  int parent = -1;   // parent part
  size_t group = 0;  // part that it goes with, itself for one that moves
  int joint = -1;
};

class PartTree {
 public:
  PartTree(const Character& mesh, Axis up, const std::array<float, 3>& front)
      : mesh_(mesh), of_(connected_parts(mesh)), axes_(up, front) {
    parts_.resize(of_.count);
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
      const Point3 p = axes_.local(mesh.vertices[v]);
      parts_[of_.part[v]].box.add(p);
      whole_.add(p);
    }
    size_ = whole_.longest();
  }

  bool build() {
    if (parts_.size() <= kFewestMoving || parts_.size() > kMostParts || !(size_ > 0)) return false;
    find_trunk();
    if (!hang()) return false;
    merge();
    return true;
  }

  // Where what is small lies from the torso, along one of the two horizontal axes of the mesh.
  std::optional<std::array<float, 3>> front_of_details() const {
    Point3 sum = {};
    double count = 0;
    for (const SolidPart& part : parts_) {
      if (part.box.longest() >= kSmall * size_) continue;
      sum = sum + (part.box.middle() - trunk().middle());
      count += 1;
    }
    if (count < 2) return std::nullopt;
    const Point3 mean = (1 / count) * sum;
    const size_t a = std::abs(mean[kLeft]) > std::abs(mean[kFront]) ? kLeft : kFront;
    if (std::abs(mean[a]) < 0.2 * trunk().side(a)) return std::nullopt;
    const Point3 axis = (mean[a] < 0 ? -1.0 : 1.0) * axes_.of[a];
    return std::array<float, 3>{static_cast<float>(axis[0]), static_cast<float>(axis[1]), static_cast<float>(axis[2])};
  }

  std::optional<PartSkeleton> skeleton(const std::array<float, 3>& front) {
    PartSkeleton out;
    out.front = front;
    if (trunk().side(kFront) <= kLying * trunk().side(kUp)) return std::nullopt;
    name_limbs();
    std::array<size_t, 2> legs = {};  // left, right
    size_t moving = 0;
    for (const Limb& limb : limbs_)
      if (limb.is_leg) ++legs[limb.names[0].rfind("Left", 0) == 0 ? 0 : 1];
    for (size_t p = 0; p < parts_.size(); ++p) moving += p != trunk_ && parts_[p].group == p ? 1 : 0;
    if (moving < kFewestMoving || legs[0] < 2 || legs[0] != legs[1]) return std::nullopt;
    out.joints.push_back({"Hips", world(hips()), -1, true});
    parts_[trunk_].joint = 0;
    for (const Limb& limb : limbs_) add_limb(limb.part, limb.names, 0, &out.joints);
    out.joint_of.resize(mesh_.vertices.size());
    for (size_t v = 0; v < out.joint_of.size(); ++v)
      out.joint_of[v] = static_cast<uint32_t>(parts_[parts_[of_.part[v]].group].joint);
    return out;
  }

 private:
  struct Limb {
    size_t part = 0;
    std::vector<std::string> names;  // along the chain; the last one is counted on
    bool is_leg = false;
  };

  const PartBox& trunk() const { return parts_[trunk_].box; }

  Vec3 world(const Point3& p) const { return axes_.world(p); }
  bool touch(size_t a, size_t b) const { return gap(parts_[a].box, parts_[b].box) <= kTouch * size_; }
  bool is_small(size_t p) const { return parts_[p].box.longest() < kSmall * size_; }

  // The part that most others touch; of equal ones the largest.
  void find_trunk() {
    std::pair<size_t, double> most = {0, 0};
    for (size_t p = 0; p < parts_.size(); ++p) {
      size_t touching = 0;
      for (size_t q = 0; q < parts_.size(); ++q) touching += q != p && !is_small(q) && touch(p, q) ? 1 : 0;
      const std::pair<size_t, double> own = {touching, volume(parts_[p].box, 0)};
      if (own <= most) continue;
      most = own;
      trunk_ = p;
    }
  }

  // Level by level; the parent of a part is the one with the largest contact. Returns false if a part has none.
  bool hang() {
    std::vector<char> reached(parts_.size(), 0);
    reached[trunk_] = 1;
    order_ = {trunk_};
    for (double reach = kTouch; order_.size() < parts_.size();) {
      std::vector<size_t> level;
      for (size_t p = 0; p < parts_.size(); ++p) {
        if (reached[p] != 0) continue;
        double best = -1;
        for (const size_t q : order_) {
          if (gap(parts_[p].box, parts_[q].box) > reach * size_) continue;
          const double shared = volume(common(parts_[p].box, parts_[q].box), kTouch * size_);
          if (shared <= best) continue;
          best = shared;
          parts_[p].parent = static_cast<int>(q);
        }
        if (best >= 0) level.push_back(p);
      }
      for (const size_t p : level) reached[p] = 1;
      order_.insert(order_.end(), level.begin(), level.end());
      if (!level.empty()) continue;
      if (reach >= kFarthest) return false;
      reach = kFarthest;
    }
    return true;
  }

  bool is_within(const PartBox& inner, const PartBox& outer) const {
    const double thin = 1e-3 * size_;
    for (size_t a = 0; a < 3; ++a)
      if (inner.low[a] > outer.high[a] || inner.high[a] < outer.low[a]) return false;
    return volume(common(inner, outer), thin) >= kWithin * volume(inner, thin);
  }
  // Belts and blankets lie around a torso; saddles, humps, and a block animal's ears over it.
  bool lies_around(const PartBox& box) const {
    const Point3 middle = box.middle();
    for (const size_t a : {kLeft, kFront})
      if (middle[a] < trunk().low[a] || middle[a] > trunk().high[a]) return false;
    return middle[kUp] >= trunk().low[kUp];
  }

  void merge() {
    for (const size_t p : order_) {
      SolidPart& part = parts_[p];
      part.group = p;
      if (p == trunk_) continue;
      const size_t above = parts_[static_cast<size_t>(part.parent)].group;
      if (is_small(p) || is_within(part.box, parts_[above].box) || (above == trunk_ && lies_around(part.box))) {
        part.group = above;
        continue;
      }
      for (const size_t q : order_) {  // two that are one: a neck inside a head
        if (q == p) break;
        if (q == trunk_ || parts_[q].group != q || parts_[static_cast<size_t>(parts_[q].parent)].group != above)
          continue;
        if (is_within(part.box, parts_[q].box)) part.group = q;
      }
    }
    for (const size_t p : order_)  // children of a part that moves with another, found later
      if (p != trunk_ && parts_[p].group != p) parts_[p].group = parts_[parts_[p].group].group;
  }

  std::vector<size_t> below(size_t p) const {
    std::vector<size_t> out;
    for (const size_t q : order_)
      if (q != trunk_ && q != p && parts_[q].group == q && parts_[static_cast<size_t>(parts_[q].parent)].group == p)
        out.push_back(q);
    return out;
  }
  double lowest(size_t p) const {
    double low = parts_[p].box.low[kUp];
    for (const size_t q : below(p)) low = std::min(low, lowest(q));
    return low;
  }

  // Among several parts at the front the largest is the head; the others go with it, or with the torso.
  void choose_head(const std::vector<size_t>& heads) {
    if (heads.empty()) return;
    const auto smaller = [&](size_t a, size_t b) { return volume(parts_[a].box, 0) < volume(parts_[b].box, 0); };
    const size_t head = *std::max_element(heads.begin(), heads.end(), smaller);
    for (const size_t p : heads)
      if (p != head) join(p, touch(p, head) ? head : trunk_);
    const std::vector<size_t> above = below(head);
    const bool is_neck = std::any_of(above.begin(), above.end(), [&](size_t p) { return smaller(head, p); });
    limbs_.push_back({head, is_neck ? std::vector<std::string>{"Neck", "Head"} : std::vector<std::string>{"Head"}});
  }
  void join(size_t from, size_t to) {
    for (SolidPart& part : parts_)
      if (part.group == from) part.group = to;
  }

  void name_limbs() {
    limbs_.clear();
    std::vector<size_t> legs, heads;
    const Point3 own = trunk().middle();
    for (const size_t p : below(trunk_)) {
      const PartBox& box = parts_[p].box;
      const Point3 middle = box.middle();
      const double across = 0.1 * box.side(kLeft);
      const bool left = box.low[kLeft] > own[kLeft] - across, right = box.high[kLeft] < own[kLeft] + across;
      if (lowest(p) <= whole_.low[kUp] + kOnGround * size_ && middle[kUp] < own[kUp]) {
        legs.push_back(p);
      } else if (left || right) {
        limbs_.push_back({p, {left ? "LeftWing" : "RightWing"}});
      } else if (middle[kFront] > own[kFront]) {
        heads.push_back(p);
      } else {
        limbs_.push_back({p, {middle[kFront] < own[kFront] ? "Tail" : "Bone"}});
      }
    }
    choose_head(heads);
    for (const double side : {1.0, -1.0}) name_legs(side, legs);
  }

  // From behind forwards: of two or more the foremost is an arm, as votes call it.
  void name_legs(double side, const std::vector<size_t>& legs) {
    std::vector<size_t> own;
    for (const size_t p : legs)
      if (side * (parts_[p].box.middle()[kLeft] - trunk().middle()[kLeft]) > 0) own.push_back(p);
    std::stable_sort(own.begin(), own.end(), [&](size_t a, size_t b) {
      return parts_[a].box.middle()[kFront] < parts_[b].box.middle()[kFront];
    });
    const std::string name = side > 0 ? "Left" : "Right";
    for (size_t i = 0; i < own.size(); ++i) {
      if (i > 0 && i + 1 == own.size())
        limbs_.push_back({own[i], {name + "Arm", name + "ForeArm", name + "Hand"}, true});
      else
        limbs_.push_back({own[i], {name + "UpLeg", name + "Leg", name + "Foot", name + "ToeBase"}, true});
    }
  }

  // Between the hind legs.
  Point3 hips() const {
    Point3 at = trunk().middle();
    double sum = 0, count = 0;
    for (const Limb& limb : limbs_) {
      if (!limb.is_leg || limb.names[0].find("UpLeg") == std::string::npos) continue;
      sum += parts_[limb.part].box.middle()[kFront];
      count += 1;
    }
    if (count > 0) at[kFront] = std::clamp(sum / count, trunk().low[kFront], trunk().high[kFront]);
    return at;
  }

  void add_limb(size_t p, const std::vector<std::string>& names, size_t depth, std::vector<Joint>* joints) {
    SolidPart& part = parts_[p];
    const size_t above = parts_[static_cast<size_t>(part.parent)].group;
    std::string name = depth < names.size() ? names[depth] : names.back() + std::to_string(depth + 1 - names.size());
    if (depth >= names.size() && names.back() == "Head") {
      const double off = part.box.middle()[kLeft] - parts_[above].box.middle()[kLeft];
      const bool is_ear = std::abs(off) > 0.1 * parts_[above].box.side(kLeft) &&
                          part.box.middle()[kUp] > parts_[above].box.middle()[kUp];
      name = is_ear ? (off > 0 ? "LeftEar" : "RightEar") : "Bone";
    }
    const std::string base = name;
    const auto taken = [&](const Joint& joint) { return joint.name == name; };
    for (int number = 2; std::any_of(joints->begin(), joints->end(), taken); ++number)
      name = base + std::to_string(number);
    Point3 at = common(part.box, parts_[above].box).middle();
    for (size_t a = 0; a < 3; ++a) at[a] = std::clamp(at[a], part.box.low[a], part.box.high[a]);
    part.joint = static_cast<int>(joints->size());
    joints->push_back({name, world(at), parts_[above].joint, true});
    const std::vector<size_t> children = below(p);
    for (const size_t child : children) add_limb(child, names, depth + 1, joints);
    if (!children.empty()) return;
    Point3 end = 2.0 * part.box.middle() - at;
    for (size_t a = 0; a < 3; ++a) end[a] = std::clamp(end[a], part.box.low[a], part.box.high[a]);
    joints->push_back({name + "_end", world(end), part.joint, false});
  }

  const Character& mesh_;
  const MeshParts of_;
  const BodyAxes axes_;
  std::vector<SolidPart> parts_;
  std::vector<size_t> order_;  // parts, parents first
  PartBox whole_;
  double size_ = 0;
  size_t trunk_ = 0;
  std::vector<Limb> limbs_;
};

}  // namespace

std::optional<PartSkeleton> part_skeleton(const Character& mesh, Axis up, const std::array<float, 3>& front,
                                          bool front_sure) {
  PartTree tree(mesh, up, front);
  if (!tree.build()) return std::nullopt;
  const auto seen = front_sure ? std::nullopt : tree.front_of_details();
  if (!seen) return tree.skeleton(front);
  PartTree turned(mesh, up, *seen);
  std::optional<PartSkeleton> skeleton = turned.build() ? turned.skeleton(*seen) : std::nullopt;
  if (skeleton) skeleton->front_seen = true;
  return skeleton;
}

}  // namespace sinew
