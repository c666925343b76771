// SPDX-License-Identifier: MIT
// Fingers of a skeleton that was fitted into a mesh go where the mesh's are.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "predict/fit_details.hpp"
#include "predict/limbs.hpp"
#include "predict/turn.hpp"
#include "sinew_character/predict/predict_details.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/joint_tree.hpp"

namespace sinew {
namespace {

constexpr size_t kFingers = 5;
constexpr size_t kFewestFingers = 3;  // that give the orientation of a hand

struct Hand {
  size_t joint = 0;
  std::array<std::vector<size_t>, kFingers> fingers;  // from the palm outward, a bone end at last where there is one
};

// The ancestor hand of a finger's joint; without one, the parent of the finger; -1: none.
int hand_above(const std::vector<Joint>& joints, const std::vector<uint8_t>& classes, size_t finger) {
  int palm = -1;
  for (int above = joints[finger].parent; above >= 0; above = joints[joint_index(above)].parent) {
    if (classes[joint_index(above)] == SINEW_CLASS_HAND) return above;
    if (palm < 0 && !is_finger_class(classes[joint_index(above)])) palm = above;
  }
  return palm;
}

// [H] by the parent of the fingers. Palm bones belong to their fingers.
std::vector<Hand> hands_of(const std::vector<Joint>& joints, const std::vector<uint8_t>& classes) {
  std::map<size_t, std::array<std::map<size_t, size_t>, kFingers>> depths;  // of hands' fingers' joints
  for (size_t j = 0; j < joints.size(); ++j) {
    const int hand = is_finger_class(classes[j]) ? hand_above(joints, classes, j) : -1;
    if (hand < 0) continue;
    std::vector<size_t> chain;  // from the joint to the hand
    for (size_t k = j; k != joint_index(hand); k = joint_index(joints[k].parent)) chain.push_back(k);
    for (size_t k = 0; k < chain.size(); ++k)
      depths[joint_index(hand)][classes[j] - SINEW_CLASS_THUMB][chain[k]] = chain.size() - k;
  }
  std::vector<Hand> out;
  for (const auto& one : depths) {
    Hand hand;
    hand.joint = one.first;
    for (size_t f = 0; f < kFingers; ++f) {
      const std::map<size_t, size_t>& depth = one.second[f];
      for (const auto& finger : depth) hand.fingers[f].push_back(finger.first);
      std::stable_sort(hand.fingers[f].begin(), hand.fingers[f].end(),
                       [&](size_t a, size_t b) { return depth.at(a) < depth.at(b); });
    }
    out.push_back(std::move(hand));
  }
  return out;
}

std::vector<Point3> points_of(const std::vector<Joint>& joints, const std::vector<size_t>& chain) {
  std::vector<Point3> out;
  for (const size_t j : chain) out.push_back(point(joints[j].position));
  return out;
}

// Where a finger's joints go: as many as are found, one by one from its tip; what is more at its root lies between the hand and
// the first of these. Of fewer, at the same shares of its length.
std::vector<Point3> finger_points(const std::vector<Point3>& mine, const Point3& my_hand,
                                  const std::vector<Point3>& found, const Point3& found_hand) {
  std::vector<Point3> out(mine.size());
  if (mine.size() >= found.size()) {
    const size_t more = mine.size() - found.size();
    const double palm = length(mine[more] - my_hand);
    for (size_t k = 0; k < more; ++k) {
      const double share = palm > 0 ? std::min(1.0, length(mine[k] - my_hand) / palm) : 0;
      out[k] = found_hand + share * (found.front() - found_hand);
    }
    for (size_t k = more; k < mine.size(); ++k) out[k] = found[k - more];
    return out;
  }
  const std::vector<double> before = lengths_along(mine, 0, mine.size() - 1);
  for (size_t k = 0; k < mine.size(); ++k)
    out[k] = point_along(found, 0, found.size() - 1, before.back() > 0 ? before[k] / before.back() : 0);
  return out;
}

// f(joint of mine, where it goes) of fingers that both hands have. Returns how many these are.
template <typename F>
size_t each_point(const std::vector<Joint>& joints, const Hand& mine, const PredictedSkeleton& found,
                  const Hand& theirs, const F& f) {
  size_t fingers = 0;
  for (size_t k = 0; k < kFingers; ++k) {
    if (mine.fingers[k].empty() || theirs.fingers[k].size() < 2) continue;
    ++fingers;
    const std::vector<Point3> to =
        finger_points(points_of(joints, mine.fingers[k]), point(joints[mine.joint].position),
                      points_of(found.joints, theirs.fingers[k]), point(found.joints[theirs.joint].position));
    for (size_t i = 0; i < to.size(); ++i) f(mine.fingers[k][i], to[i]);
  }
  return fingers;
}

// From a hand to the farthest joint of its fingers.
double reach(const std::vector<Joint>& joints, const Hand& hand) {
  double farthest = 0;
  for (const std::vector<size_t>& finger : hand.fingers)
    for (const size_t j : finger)
      farthest = std::max(farthest, length(point(joints[j].position) - point(joints[hand.joint].position)));
  return farthest;
}

}  // namespace

bool has_fingers(const std::vector<Joint>& joints) {
  const std::vector<uint8_t> classes = joint_verdicts(joints).classes;
  return std::any_of(classes.begin(), classes.end(), is_finger_class);
}

bool is_lone_hand(const PredictedSkeleton& skeleton) {
  const auto of_a_hand = [](uint8_t c) {
    return is_finger_class(c) || c == SINEW_CLASS_HAND || c == SINEW_CLASS_FOREARM;
  };
  return std::any_of(skeleton.classes.begin(), skeleton.classes.end(), is_finger_class) &&
         std::all_of(skeleton.classes.begin(), skeleton.classes.end(), of_a_hand);
}

size_t fit_fingers(const PredictedSkeleton& found, FittedSkeleton* fitted) {
  const std::vector<Hand> theirs = hands_of(found.joints, found.classes);
  if (theirs.empty()) return 0;
  JointMirror mirror;
  if (fitted->symmetric) mirror = find_joint_mirror(fitted->joints);
  size_t fingers = 0;
  const std::vector<Joint> before = fitted->joints;
  for (const Hand& mine : hands_of(before, joint_verdicts(before).classes)) {
    const Hand* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Hand& hand : theirs) {
      const double d = length(point(before[mine.joint].position) - point(found.joints[hand.joint].position));
      if (d >= std::min(least, reach(found.joints, hand))) continue;
      least = d;
      nearest = &hand;
    }
    if (nearest == nullptr) continue;
    fingers += each_point(before, mine, found, *nearest, [&](size_t j, const Point3& p) {
      fitted->joints[j].position = to_vec3(p);
      fitted->how[j] = FitHow::kMatched;
    });
  }
  if (fitted->symmetric)
    for (size_t j = 0; j < before.size(); ++j) {
      const int other = mirror.partners[j];
      if (other > static_cast<int>(j) && fitted->how[j] == FitHow::kMatched)
        fitted->joints[joint_index(other)].position = mirrored(fitted->joints[j].position, mirror.axis, mirror.plane);
    }
  return fingers;
}

std::optional<FittedSkeleton> fit_lone_hand(const std::vector<Joint>& own, const PredictedSkeleton& found) {
  const std::vector<Hand> mine = hands_of(own, joint_verdicts(own).classes),
                          theirs = hands_of(found.joints, found.classes);
  if (mine.size() != 1 || theirs.size() != 1) return std::nullopt;
  const Point3 from = point(own[mine[0].joint].position), to = point(found.joints[theirs[0].joint].position);
  std::vector<RotationPair> pairs;
  double before = 0, after = 0;
  const size_t fingers = each_point(own, mine[0], found, theirs[0], [&](size_t j, const Point3& p) {
    pairs.push_back({point(own[j].position) - from, p - to, 1});
    before += length(pairs.back().from);
    after += length(pairs.back().to);
  });
  if (fingers < kFewestFingers || !(before > 0) || !(after > 0)) return std::nullopt;
  const Rotation rotation = best_rotation(pairs, kNoRotation);
  FittedSkeleton fitted;
  fitted.joints = own;
  fitted.scale = after / before;
  for (Joint& joint : fitted.joints)
    joint.position = to_vec3(to + fitted.scale * turned(rotation, point(joint.position) - from));
  fitted.how.assign(own.size(), FitHow::kCarried);
  fitted.how[mine[0].joint] = FitHow::kMatched;
  (void)fit_fingers(found, &fitted);
  fitted.matched = static_cast<size_t>(std::count(fitted.how.begin(), fitted.how.end(), FitHow::kMatched));
  fitted.matchable = own.size();
  return fitted;
}

}  // namespace sinew
