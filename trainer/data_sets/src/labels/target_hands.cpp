// SPDX-License-Identifier: MIT
// Fingers by names below joints of class hand.
#include <algorithm>
#include <cmath>
#include <map>

#include "names/joint_name.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using namespace rigging;

constexpr double kLeastVertices = 0.5;  // by weight, that a joint has to move
constexpr double kQuantile = 0.98, kEndShare = 0.95;
constexpr size_t kMostJoints = 3, kFewestFingers = 3;

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
}

class HandFinder {
 public:
  explicit HandFinder(const Character& c) : c_(c), moved_(c.joints.size(), 0), children_(c.joints.size()) {
    for (size_t j = 0; j < c.joints.size(); ++j) {
      if (c.joints[j].parent >= 0) children_[static_cast<size_t>(c.joints[j].parent)].push_back(static_cast<int>(j));
    }
    for (const auto& row : c.influences)
      for (const Influence& i : row) moved_[i.joint] += static_cast<double>(i.weight);
    const JointVerdicts verdicts = joint_verdicts(c.joints, follows_of(c));
    for (size_t j = 0; j < c.joints.size(); ++j) {
      const uint8_t joint_class = verdicts.classes[j];
      fingers_.emplace_back();
      classes_.emplace_back();
      if (joint_class >= SINEW_CLASS_THUMB && joint_class <= SINEW_CLASS_PINKY)
        fingers_.back() = joint_class - uint32_t{SINEW_CLASS_THUMB};
      else if (verdicts.is_part(j) && joint_class < kJointClasses)
        classes_.back() = static_cast<JointClass>(joint_class);
      sides_.push_back(verdicts.sides[j]);
      ends_.push_back(verdicts.is_end(j));
      untold_.push_back(joint_class == SINEW_CLASS_OTHER &&
                        names::read_joint_name(c.joints[j].name.c_str()).part == names::Part::kFingers);
    }
  }

  std::vector<TargetHand> run() {
    std::vector<TargetHand> hands;
    for (size_t j = 0; j < c_.joints.size(); ++j) {
      if (classes_[j] != kClassHand || is_finger(j) || ends_[j]) continue;
      below_ = all_below(j);
      // A hand of a hand: palms, and what a hand holds.
      const int above = body_parent(j);
      if (above >= 0 && classes_[static_cast<size_t>(above)] == kClassHand) continue;
      double moved = 0;
      for (const size_t b : below_) moved += moved_[b];
      if (moved < kLeastVertices) continue;
      hands.push_back(hand(j));
    }
    return hands;
  }

 private:
  bool is_finger(size_t j) const { return fingers_[j].has_value(); }
  int body_parent(size_t j) const {
    int above = c_.joints[j].parent;
    while (above >= 0 && !classes_[static_cast<size_t>(above)]) above = c_.joints[static_cast<size_t>(above)].parent;
    return above;
  }
  std::vector<size_t> all_below(size_t top) const {
    std::vector<size_t> found = {top};
    for (size_t i = 0; i < found.size(); ++i)
      for (const int child : children_[found[i]]) found.push_back(static_cast<size_t>(child));
    return found;
  }

  TargetHand hand(size_t j) {
    TargetHand hand;
    hand.joint = static_cast<uint32_t>(j);
    const Point3 wrist = point(c_.joints[j].position);
    hand.elbow = body_parent(j);
    const auto is_forearm = [&](int above) {
      const auto& one = classes_[static_cast<size_t>(above)];
      return one && *one == kClassForearm;
    };
    while (hand.elbow >= 0 && !is_forearm(hand.elbow) &&
           length(point(c_.joints[static_cast<size_t>(hand.elbow)].position) - wrist) < 1e-4)
      hand.elbow = body_parent(static_cast<size_t>(hand.elbow));
    hand.right = sides_[j] != 0 ? sides_[j] < 0 : wrist[0] < 0;

    std::vector<bool> inside(c_.joints.size(), false);
    for (const size_t b : below_) inside[b] = true;
    std::vector<double> reach;
    for (size_t v = 0; v < c_.vertices.size(); ++v) {
      for (const Influence& i : c_.influences[v]) {
        if (!inside[i.joint] || i.weight < 0.5f) continue;
        reach.push_back(length(point(c_.vertices[v]) - wrist));
        break;
      }
    }
    hand.length = reach.empty() ? 0 : quantile(std::move(reach), kQuantile);
    for (const size_t b : below_) {
      if (b == j || moved_[b] < kLeastVertices) continue;
      hand.clear = hand.clear && (is_finger(b) || !untold_[b]);
    }
    for (uint32_t f = 0; f < 5; ++f) add_finger(f, &hand);
    hand.clear = hand.clear && (hand.fingers.empty() || hand.fingers.size() >= kFewestFingers) && hand.length > 0;
    return hand;
  }

  void add_finger(uint32_t f, TargetHand* hand) const {
    TargetFinger finger;
    finger.finger = f;
    size_t last = 0;
    for (const size_t b : below_) {  // parents first
      if (!is_finger(b) || *fingers_[b] != f || moved_[b] < kLeastVertices) continue;
      const bool follows = finger.joints.empty() || is_below(b, finger.joints.back());
      if (!follows) continue;
      finger.joints.push_back(static_cast<uint32_t>(b));
      last = b;
    }
    if (finger.joints.empty()) return;
    if (finger.joints.size() > kMostJoints)
      finger.joints.erase(finger.joints.begin(), finger.joints.end() - static_cast<long>(kMostJoints));
    for (const uint32_t j : finger.joints) finger.positions.push_back(point(c_.joints[j].position));
    finger.end = end_of(last, finger);
    hand->fingers.push_back(std::move(finger));
  }

  bool is_below(size_t j, size_t top) const {
    for (int above = c_.joints[j].parent; above >= 0; above = c_.joints[static_cast<size_t>(above)].parent)
      if (static_cast<size_t>(above) == top) return true;
    return false;
  }

  // The file's, or how far its vertices reach along the bone before it.
  std::optional<Point3> end_of(size_t last, const TargetFinger& finger) const {
    const Point3 from = point(c_.joints[last].position);
    if (children_[last].size() == 1) {
      const size_t child = static_cast<size_t>(children_[last][0]);
      const Point3 at = point(c_.joints[child].position);
      if (moved_[child] < kLeastVertices && length(at - from) > 1e-6) return at;
    }
    Point3 along{};
    std::vector<Point3> offsets;
    for (size_t v = 0; v < c_.vertices.size(); ++v) {
      for (const Influence& i : c_.influences[v]) {
        if (i.joint != last || !(i.weight > 0.5f)) continue;
        offsets.push_back(point(c_.vertices[v]) - from);
        for (size_t k = 0; k < 3; ++k) along[k] += offsets.back()[k];
      }
    }
    if (offsets.empty()) return std::nullopt;
    if (finger.positions.size() > 1) along = from - finger.positions[finger.positions.size() - 2];
    const double norm = length(along);
    if (norm < 1e-9) return std::nullopt;
    std::vector<double> reach;
    for (double& one : along) one /= norm;
    for (const Point3& offset : offsets) reach.push_back(dot(offset, along));
    const double far = kEndShare * quantile(std::move(reach), kQuantile);
    if (far <= 1e-6) return std::nullopt;
    return Point3{from[0] + far * along[0], from[1] + far * along[1], from[2] + far * along[2]};
  }

  const Character& c_;
  std::vector<double> moved_;  // [J] vertices by weight
  std::vector<std::vector<int>> children_;
  std::vector<std::optional<uint32_t>> fingers_;
  std::vector<std::optional<JointClass>> classes_;
  std::vector<int8_t> sides_;
  std::vector<bool> ends_, untold_;  // untold_: a finger of unknown class
  std::vector<size_t> below_;        // the hand, then all below it
};

}  // namespace

std::vector<TargetHand> target_hands(const Character& character) {
  if (character.joints.empty() || character.influences.size() != character.vertices.size())
    throw Error(character.name + ": has no joints or weights, so no hands to train on");
  return HandFinder(character).run();
}

TargetSkeleton with_fingers(const Character& character, TargetSkeleton body) {
  std::vector<TargetJoint> ends;
  for (const TargetHand& hand : target_hands(character)) {
    if (!hand.clear) continue;
    const int owner = static_cast<int>(body.owners[hand.joint]);
    const std::vector<TargetJoint>& joints = body.joints;
    for (const TargetFinger& finger : hand.fingers) {
      int parent = owner;
      for (size_t k = 0; k < finger.joints.size(); ++k) {
        TargetJoint joint;
        joint.name = character.joints[finger.joints[k]].name;
        joint.position = finger.positions[k];
        joint.parent = parent;
        joint.source = finger.joints[k];
        parent = static_cast<int>(joints.size());
        body.joints.push_back(std::move(joint));
      }
      if (!finger.end) continue;
      TargetJoint end;
      end.name = body.joints.back().name + "_end";
      end.position = *finger.end;
      end.parent = parent;
      end.tip = true;
      end.source = body.joints.back().source;
      ends.push_back(std::move(end));
    }
  }
  body.joints.insert(body.joints.end(), ends.begin(), ends.end());
  return body;
}

}  // namespace sinew
