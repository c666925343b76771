// SPDX-License-Identifier: MIT
// Distances between skeletons, pairs of joints, and connected joints.
#include "sinew_trainer/rig_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "score/numpy.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using namespace rigging;

constexpr double kBoneStep = 0.005;
constexpr double kPairDistance = 0.05;
constexpr double kUnpairedCost = 10;  // more than all pairs together for any skeleton below 200 joints
constexpr double kMirrorError = 2e-6;
constexpr double kRigMiddle = 0.01, kBeside = 0.005;  // from the mirror plane

double distance_of(const Point3& a, const Point3& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return std::sqrt(x * x + y * y + z * z);
}

// The distance of every point to the nearest of `others`. Plain search: a few thousand points take milliseconds.
std::vector<double> nearest_distances(const std::vector<Point3>& points, const std::vector<Point3>& others) {
  std::vector<double> x, y, z;
  for (const Point3& p : points) {
    x.push_back(p[0]);
    y.push_back(p[1]);
    z.push_back(p[2]);
  }
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  for (const Point3& q : others) {
    for (size_t i = 0; i < nearest.size(); ++i) {
      const double dx = x[i] - q[0], dy = y[i] - q[1], dz = z[i] - q[2];
      const double squared = dx * dx + dy * dy + dz * dz;
      nearest[i] = squared < nearest[i] ? squared : nearest[i];
    }
  }
  for (double& one : nearest) one = std::sqrt(one);
  return nearest;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Half the sum of both directions: `a` to `near_a`, `b` to `near_b`.
double both_ways(const std::vector<Point3>& a, const std::vector<Point3>& near_a, const std::vector<Point3>& b,
                 const std::vector<Point3>& near_b) {
  return 0.5 * (mean(nearest_distances(a, near_a)) + mean(nearest_distances(b, near_b)));
}

// The joints, and points along every bone with its two ends.
std::vector<Point3> bone_points(const ScoredSkeleton& skeleton) {
  std::vector<Point3> points = skeleton.positions;
  for (size_t j = 0; j < skeleton.positions.size(); ++j) {
    if (skeleton.parents[j] < 0) continue;
    const Point3 &end = skeleton.positions[j], &start = skeleton.positions[static_cast<size_t>(skeleton.parents[j])];
    const int steps = std::max(1, static_cast<int>(std::ceil(distance_of(end, start) / kBoneStep)));
    for (int k = 0; k <= steps; ++k) {
      const double t = k == steps ? 1 : k * (1.0 / steps);
      Point3 p;
      for (size_t i = 0; i < 3; ++i) p[i] = start[i] * (1 - t) + end[i] * t;
      points.push_back(p);
    }
  }
  return points;
}

std::vector<std::vector<size_t>> neighbors(const ScoredSkeleton& skeleton) {
  std::vector<std::vector<size_t>> found(skeleton.parents.size());
  for (size_t j = 0; j < found.size(); ++j) {
    if (skeleton.parents[j] < 0) continue;
    const auto parent = static_cast<size_t>(skeleton.parents[j]);
    found[j].push_back(parent);
    found[parent].push_back(j);
  }
  return found;
}

// Is there a path from one joint to the other that passes no paired joint?
bool hang_together(const std::vector<std::vector<size_t>>& next_to, const std::vector<int>& pairs, size_t from,
                   size_t to) {
  std::vector<size_t> open = {from};
  std::vector<bool> seen(next_to.size(), false);
  seen[from] = true;
  while (!open.empty()) {
    const size_t joint = open.back();
    open.pop_back();
    for (const size_t next : next_to[joint]) {
      if (next == to) return true;
      if (seen[next] || pairs[next] >= 0) continue;
      seen[next] = true;
      open.push_back(next);
    }
  }
  return false;
}

double share(size_t part, size_t whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

double joined_share(const ScoredSkeleton& predicted, const ScoredSkeleton& reference, const std::vector<int>& pairs) {
  std::vector<int> partners(reference.positions.size(), -1);
  for (size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i] >= 0) partners[static_cast<size_t>(pairs[i])] = static_cast<int>(i);
  const auto next_to = neighbors(predicted);
  size_t bones = 0, joined = 0;
  for (size_t j = 0; j < partners.size(); ++j) {
    const int parent = reference.parents[j];
    if (parent < 0 || partners[j] < 0 || partners[static_cast<size_t>(parent)] < 0) continue;
    ++bones;
    joined += hang_together(next_to, pairs, static_cast<size_t>(partners[j]),
                            static_cast<size_t>(partners[static_cast<size_t>(parent)]))
                  ? 1
                  : 0;
  }
  return share(joined, bones);
}

double class_share(const ScoredSkeleton& predicted, const ScoredSkeleton& reference, const std::vector<int>& pairs) {
  size_t joints = 0, right = 0;
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i] < 0) continue;
    const auto j = static_cast<size_t>(pairs[i]);
    if (predicted.tips[i] != 0 || reference.tips[j] != 0) continue;
    ++joints;
    right += predicted.classes[i] == reference.classes[j] ? 1 : 0;
  }
  return share(right, joints);
}

// x of the plane in the middle of all joints.
double middle(const ScoredSkeleton& skeleton) {
  const auto [low, high] = std::minmax_element(skeleton.positions.begin(), skeleton.positions.end(),
                                               [](const Point3& a, const Point3& b) { return a[0] < b[0]; });
  return ((*high)[0] + (*low)[0]) / 2;
}

bool is_symmetric(const ScoredSkeleton& skeleton) {
  const double x = middle(skeleton);
  std::vector<Point3> mirrored = skeleton.positions;
  for (Point3& p : mirrored) p[0] = 2 * x - p[0];
  const std::vector<double> off = nearest_distances(skeleton.positions, mirrored);
  return *std::max_element(off.begin(), off.end()) <= kMirrorError;
}

// Joints by class and side of the mirror plane: that of a symmetric skeleton, else the one through the root.
class SidedJoints {
 public:
  explicit SidedJoints(const ScoredSkeleton& skeleton) : skeleton_(skeleton) {
    const auto root = std::find(skeleton.parents.begin(), skeleton.parents.end(), -1) - skeleton.parents.begin();
    x_ = is_symmetric(skeleton) || root == static_cast<std::ptrdiff_t>(skeleton.parents.size())
             ? middle(skeleton)
             : skeleton.positions[static_cast<size_t>(root)][0];
  }
  std::vector<size_t> in_middle(JointClass one) const {
    return joints(one, [](double off) { return std::abs(off) <= kRigMiddle; });
  }
  std::vector<size_t> beside(JointClass one, double side) const {
    return joints(one, [side](double off) { return side * off > kBeside; });
  }

 private:
  template <class Wanted>
  std::vector<size_t> joints(JointClass one, const Wanted& wanted) const {
    std::vector<size_t> found;
    for (size_t j = 0; j < skeleton_.positions.size(); ++j)
      if (skeleton_.tips[j] == 0 && skeleton_.classes[j] == one && wanted(skeleton_.positions[j][0] - x_))
        found.push_back(j);
    return found;
  }

  const ScoredSkeleton& skeleton_;
  double x_ = 0;
};

bool is_above(const ScoredSkeleton& skeleton, size_t above, size_t joint) {
  for (int j = skeleton.parents[joint]; j >= 0; j = skeleton.parents[static_cast<size_t>(j)])
    if (static_cast<size_t>(j) == above) return true;
  return false;
}

}  // namespace

ScoredSkeleton scored_skeleton(const TargetSkeleton& target) {
  ScoredSkeleton out;
  for (const TargetJoint& joint : target.joints) {
    const Point3& p = joint.position;
    out.positions.push_back({p[0] / target.side, p[1] / target.side, p[2] / target.side});
    out.parents.push_back(joint.parent);
    out.classes.emplace_back(joint.joint_class);
    out.tips.push_back(joint.tip ? 1 : 0);
  }
  return out;
}

ScoredSkeleton scored_skeleton(const std::vector<Joint>& joints, double side) {
  ScoredSkeleton out;
  std::vector<bool> leaf(joints.size(), true);
  for (const Joint& joint : joints)
    if (joint.parent >= 0) leaf[static_cast<size_t>(joint.parent)] = false;
  const JointVerdicts verdicts = joint_verdicts(joints);
  for (size_t j = 0; j < joints.size(); ++j) {
    const Vec3& p = joints[j].position;
    out.positions.push_back(
        {static_cast<double>(p.x) / side, static_cast<double>(p.y) / side, static_cast<double>(p.z) / side});
    out.parents.push_back(joints[j].parent);
    out.classes.emplace_back();
    if (verdicts.is_part(j) && verdicts.classes[j] < kJointClasses)
      out.classes.back() = static_cast<JointClass>(verdicts.classes[j]);
    out.tips.push_back(leaf[j] && names_bone_end(joints[j].name) ? 1 : 0);
  }
  return out;
}

std::vector<int> pair_joints(const ScoredSkeleton& predicted, const ScoredSkeleton& reference) {
  const size_t rows = predicted.positions.size(), columns = reference.positions.size();
  std::vector<double> cost(rows * columns);
  for (size_t i = 0; i < rows; ++i) {
    for (size_t j = 0; j < columns; ++j) {
      const double d = distance_of(predicted.positions[i], reference.positions[j]);
      cost[i * columns + j] = d <= kPairDistance ? d : kUnpairedCost;
    }
  }
  std::vector<int> pairs = cheapest_pairs(cost, rows, columns);
  for (size_t i = 0; i < rows; ++i)
    if (pairs[i] >= 0 && cost[i * columns + static_cast<size_t>(pairs[i])] > kPairDistance) pairs[i] = -1;
  return pairs;
}

RigScore score_rig(const ScoredSkeleton& predicted, const ScoredSkeleton& reference) {
  const std::vector<Point3>&p = predicted.positions, &r = reference.positions;
  if (p.empty() || r.empty()) throw Error("a skeleton without joints cannot be compared");
  RigScore score;
  const std::vector<Point3> predicted_bones = bone_points(predicted), reference_bones = bone_points(reference);
  score.j2j = both_ways(p, r, r, p);
  score.j2b = both_ways(p, reference_bones, r, predicted_bones);
  score.b2b = both_ways(predicted_bones, reference_bones, reference_bones, predicted_bones);
  const std::vector<int> pairs = pair_joints(predicted, reference);
  const auto paired = static_cast<size_t>(std::count_if(pairs.begin(), pairs.end(), [](int j) { return j >= 0; }));
  score.precision = share(paired, p.size());
  score.recall = share(paired, r.size());
  score.iou = share(2 * paired, p.size() + r.size());
  score.joined = joined_share(predicted, reference, pairs);
  score.classes = class_share(predicted, reference, pairs);
  score.symmetric = is_symmetric(predicted) ? 1 : 0;
  return score;
}

bool is_humanoid(const ScoredSkeleton& reference) {
  const auto has = [&](JointClass one) {
    return std::find(reference.classes.begin(), reference.classes.end(), std::optional<JointClass>(one)) !=
           reference.classes.end();
  };
  return has(kClassPelvis) && has(kClassUpperArm) && has(kClassForearm) && has(kClassThigh) && has(kClassCalf) &&
         has(kClassHead) && !has(kClassTail);
}

std::vector<std::string> humanoid_gaps(const ScoredSkeleton& skeleton) {
  if (skeleton.positions.empty()) return {"no joints"};
  std::vector<std::string> gaps;
  const SidedJoints joints(skeleton);
  for (const JointClass one : {kClassPelvis, kClassSpine, kClassHead})
    if (joints.in_middle(one).empty()) gaps.push_back(std::string("no ") + joint_class_text(one) + " in the middle");
  const std::vector<size_t> pelvises = joints.in_middle(kClassPelvis);
  if (!pelvises.empty() &&
      std::all_of(pelvises.begin(), pelvises.end(), [&](size_t j) { return skeleton.parents[j] >= 0; }))
    gaps.push_back("the pelvis is not the root");
  for (const double side : {1.0, -1.0}) {
    for (const auto& limb : {std::array<JointClass, 3>{kClassUpperArm, kClassForearm, kClassHand},
                             std::array<JointClass, 3>{kClassThigh, kClassCalf, kClassFoot}}) {
      std::optional<size_t> above;
      for (const JointClass one : limb) {
        const std::vector<size_t> found = joints.beside(one, side);
        const std::string name = std::string(side > 0 ? "left " : "right ") + joint_class_text(one);
        if (found.empty()) gaps.push_back("no " + name);
        if (found.size() > 1) gaps.push_back(std::to_string(found.size()) + " of " + name);
        if (!found.empty() && above && !is_above(skeleton, *above, found[0]))
          gaps.push_back(name + " is not below the bone before it");
        above = found.empty() ? std::nullopt : std::optional<size_t>(found[0]);
      }
    }
  }
  return gaps;
}

}  // namespace sinew
