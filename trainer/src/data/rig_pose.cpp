// SPDX-License-Identifier: MIT
// Rotations by class of joint, arms along the body, legs in a stride.
#include "data/rig_pose.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "data/eigen_points.hpp"

namespace sinew {
namespace {

using namespace rigging;

using Eigen::Vector3d;

// Rotation of joints of a class, standard deviation in radians.
double mild_sigma(JointClass c) {
  switch (c) {
    case kClassUpperArm:
      return 0.45;
    case kClassForearm:
    case kClassWing:
    case kClassHair:
    case kClassEar:
      return 0.3;
    case kClassThigh:
    case kClassCalf:
    case kClassTail:
      return 0.25;
    case kClassHand:
      return 0.2;
    case kClassToe:
      return 0.1;
    case kClassSpine:
    case kClassClavicle:
      return 0.08;
    case kClassHip:
      return 0.05;
    case kClassPelvis:
      return 0;
    default:
      return 0.15;
  }
}

double wide_sigma(JointClass c) {
  switch (c) {
    case kClassUpperArm:
    case kClassForearm:
      return 0.45;
    case kClassCalf:
      return 0.4;
    case kClassThigh:
    case kClassWing:
      return 0.35;
    case kClassTail:
    case kClassEar:
    case kClassHair:
      return 0.3;
    case kClassHand:
      return 0.25;
    case kClassNeck:
    case kClassHead:
      return 0.2;
    case kClassSpine:
      return 0.12;
    case kClassToe:
      return 0.1;
    case kClassClavicle:
    case kClassHip:
      return 0.06;
    case kClassPelvis:
      return 0;
    default:
      return 0.15;
  }
}

// Partners mirror each other: what was drawn for the first counts for both. Whether it did.
bool mirror_partner(const PoseBody& body, size_t bone, RigPose* pose) {
  const int partner = body.partner[bone];
  if (!pose->symmetric || partner < 0 || partner >= static_cast<int>(bone)) return false;
  const size_t p = static_cast<size_t>(partner);
  pose->turn[bone] = pose->turn[p].cwiseProduct(Vector3d(1, -1, -1));
  pose->stretch[bone] = pose->stretch[p];
  return true;
}

RigPose still_pose(const PoseBody& body, bool symmetric) {
  RigPose pose;
  pose.symmetric = symmetric;
  pose.turn.assign(body.bones(), Vector3d::Zero());
  pose.stretch.assign(body.bones(), {0, 0});
  pose.aim.assign(body.bones(), Vector3d::Zero());
  return pose;
}

template <class Sigma>
RigPose draw_pose(const PoseBody& body, double strength, bool symmetric, double still, Sigma&& class_sigma,
                  Random* random) {
  RigPose pose = still_pose(body, symmetric);
  for (size_t i = 0; i < body.bones(); ++i) {
    if (mirror_partner(body, i, &pose)) continue;
    const JointClass c = body.target.joints[i].joint_class;
    constexpr double kStrengths[3] = {0.5, 1, 1.5};
    const double sigma = class_sigma(c) * strength * kStrengths[random->below(3)];
    for (int axis = 0; axis < 3; ++axis) pose.turn[i][axis] = sigma * random->normal();
    if (random->uniform() < still) pose.turn[i].setZero();
    if (symmetric && body.partner[i] == static_cast<int>(i)) pose.turn[i].y() = pose.turn[i].z() = 0;
    const bool trunk = c == kClassPelvis || c == kClassSpine || c == kClassNeck;
    const double spread = c == kClassHead ? 0.22 : trunk ? 0.12 : 0.18;
    const double along = spread * random->normal(), across = c == kClassHead ? along : spread * random->normal();
    pose.stretch[i] = {std::clamp(strength * along, -0.5, 0.5), std::clamp(strength * across, -0.5, 0.5)};
  }
  return pose;
}

// Lowers limbs that stand out to the side.
void lower_arms(const PoseBody& body, Random* random, RigPose* pose) {
  const double out[2] = {random->uniform(0, 0.12), random->uniform(0, 0.12)};
  const double forward[2] = {random->uniform(-0.1, 0.15), random->uniform(-0.1, 0.15)};
  for (size_t i = 0; i < body.bones(); ++i) {
    const Vector3d d = body.direction(i);
    if (body.target.joints[i].joint_class != kClassUpperArm || std::abs(d.x()) <= 0.3 * d.norm()) continue;
    const size_t side = pose->symmetric || d.x() > 0 ? 0 : 1;
    pose->aim[i] = Vector3d(d.x() > 0 ? out[side] : -out[side], -1, forward[side]);
  }
}

enum class Legs { kWalk, kGallop, kSit };

// On four legs: the lowest joint of the arms is near the floor.
bool walks_on_arms(const PoseBody& body) {
  double top = 1e-9, low = 1e9;
  for (size_t i = 0; i < body.target.joints.size(); ++i) {
    const JointClass c = body.target.joints[i].joint_class;
    top = std::max(top, body.joints[i][1]);
    if (c == kClassForearm || c == kClassHand) low = std::min(low, body.joints[i][1]);
  }
  return low < 0.15 * top;
}

// How many joints of a chain of one class lie between the torso and this one.
size_t steps_in_class(const PoseBody& body, size_t bone) {
  size_t steps = 0;
  const JointClass c = body.target.joints[bone].joint_class;
  for (int p = body.target.joints[bone].parent; p >= 0 && body.target.joints[static_cast<size_t>(p)].joint_class == c;
       p = body.target.joints[static_cast<size_t>(p)].parent)
    ++steps;
  return steps;
}

// About x: less than 0 brings what hangs down forward, more than 0 bends a knee. Of a chain of one class the first joint.
void move_legs(const PoseBody& body, Random* random, RigPose* pose) {
  const bool four = walks_on_arms(body);
  const Legs legs = four ? Legs::kGallop : random->uniform() < 0.6 ? Legs::kWalk : Legs::kSit;
  const double swing = random->uniform(0.2, 0.7), bend = random->uniform(0.6, 1.4), seat = random->uniform(0.8, 1.5);
  for (size_t i = 0; i < body.bones(); ++i) {
    const JointClass c = body.target.joints[i].joint_class;
    const bool upper = c == kClassThigh || (four && c == kClassUpperArm);
    const bool lower = c == kClassCalf || (four && c == kClassForearm);
    if ((!upper && !lower) || body.direction(i).y() > -1e-6 || steps_in_class(body, i) > 0) continue;
    const double side = body.joints[i][0] > 0 && !pose->symmetric ? 1 : -1;
    double angle = 0;
    switch (legs) {
      case Legs::kWalk:
        angle = upper ? side * swing : random->uniform(0, side > 0 ? 1.0 : 0.4);
        break;
      case Legs::kGallop:
        angle = random->uniform(-0.7, 0.7);
        break;
      case Legs::kSit:
        angle = (upper ? -seat : bend) + 0.15 * random->normal();
        break;
    }
    pose->turn[i] = Vector3d(angle, 0.3 * pose->turn[i].y(), 0.3 * pose->turn[i].z());
    if (pose->symmetric) mirror_partner(body, i, pose);
  }
}

// An animal on four legs sits or lies. Its limbs point where they would in the world, whatever the torso does.
void rest_on_floor(const PoseBody& body, Random* random, RigPose* pose) {
  const bool sits = random->uniform() < 0.5;
  const double rise = sits ? random->uniform(0.5, 1.0) : 0;
  const Vector3d thigh(0, sits ? 0.0 : -0.35, 1), calf(0, sits ? -0.7 : -0.25, -1), foot(0, -0.15, 1);
  const Vector3d upper_arm(0, -1, sits ? 0.0 : -0.8), forearm(0, sits ? -1.0 : -0.1, sits ? 0.1 : 1.0);
  const auto loose = [&](Vector3d d) -> Vector3d {
    return d + Vector3d(0.12 * random->normal(), 0.15 * random->normal(), 0.15 * random->normal());
  };
  const Vector3d aims[] = {loose(upper_arm), loose(forearm), loose(thigh), loose(calf), loose(foot)};
  constexpr JointClass kAimed[] = {kClassUpperArm, kClassForearm, kClassThigh, kClassCalf, kClassFoot};
  for (size_t i = 0; i < body.bones(); ++i) {
    const JointClass c = body.target.joints[i].joint_class;
    if (c == kClassPelvis || (c == kClassSpine && body.target.joints[i].parent < 0)) pose->turn[i] = {-rise, 0, 0};
    if (c == kClassNeck && steps_in_class(body, i) == 0) pose->turn[i].x() += random->uniform(0, 0.8) * rise;
    for (size_t k = 0; k < std::size(aims); ++k) {
      if (c != kAimed[k] || steps_in_class(body, i) > 0 || body.direction(i).norm() < 1e-9) continue;
      const double out = body.joints[i][0] > 0 ? 0.15 : -0.15;
      pose->aim[i] = pose->symmetric ? Vector3d(out, aims[k].y(), aims[k].z()) : loose(aims[k]) + Vector3d(out, 0, 0);
    }
  }
}

// A person's hands on the hips, in the pockets, or arms crossed on the chest: forearms grow together with the torso.
void hold_hands(const PoseBody& body, Random* random, RigPose* pose) {
  constexpr double kUpper[3][3] = {{0.8, -1, -0.2}, {0.25, -1, -0.15}, {0.15, -1, 0.25}};
  constexpr double kLower[3][3] = {{-0.75, -0.8, 0.35}, {-0.15, -1, 0.3}, {-1, 0.15, 0.45}};
  const uint32_t hold = random->below(3);
  for (size_t i = 0; i < body.bones(); ++i) {
    const JointClass c = body.target.joints[i].joint_class;
    if ((c != kClassUpperArm && c != kClassForearm) || body.direction(i).norm() < 1e-9) continue;
    const double* const aim = c == kClassUpperArm ? kUpper[hold] : kLower[hold];
    const double side = body.joints[i][0] > 0 ? 1 : -1, slack = pose->symmetric ? 0 : 0.12;
    pose->aim[i] = {side * aim[0] + slack * random->normal(), aim[1] + slack * random->normal(),
                    aim[2] + slack * random->normal()};
  }
}

// Wings lie along the body, joint by joint to and fro as a bird's, or all of them backward.
void fold_wings(const PoseBody& body, Random* random, RigPose* pose) {
  const bool folds = random->uniform() < 0.6;
  const double down = random->uniform(0, 0.5);
  for (size_t i = 0; i < body.bones(); ++i) {
    if (body.target.joints[i].joint_class != kClassWing || body.direction(i).norm() < 1e-9) continue;
    if (std::abs(body.joints[i][0]) < 0.01) continue;
    const double side = body.joints[i][0] > 0 ? 1 : -1, back = folds && steps_in_class(body, i) % 2 == 1 ? 1 : -1;
    pose->aim[i] = {0.12 * side, -down + 0.2 * random->normal(), back};
    if (pose->symmetric && mirror_partner(body, i, pose))
      pose->aim[i] = pose->aim[static_cast<size_t>(body.partner[i])].cwiseProduct(Vector3d(-1, 1, 1));
  }
}

// A tail, or a body that is one chain without limbs, winds in one direction.
void curl(const PoseBody& body, Random* random, RigPose* pose) {
  bool limbs = false;
  for (const TargetJoint& joint : body.target.joints) limbs = limbs || is_paired_class(joint.joint_class);
  const bool flat = !pose->symmetric && random->uniform() < 0.6;
  const double step = random->uniform(-0.7, 0.7);
  for (size_t i = 0; i < body.bones(); ++i) {
    const JointClass c = body.target.joints[i].joint_class;
    if (c != kClassTail && (limbs || c != kClassSpine)) continue;
    pose->turn[i] = Vector3d(flat ? 0.2 * step : step, flat ? step : 0, 0);
  }
}

void make_toy(const PoseBody& body, Random* random, RigPose* pose) {
  const double head = random->uniform(0.2, 0.6), limb = -random->uniform(0.1, 0.5), across = random->uniform(0, 0.25);
  for (size_t i = 0; i < body.bones(); ++i) {
    const JointClass c = body.target.joints[i].joint_class;
    if (c == kClassHead) pose->stretch[i] = {head, head};
    if (c >= kClassUpperArm && c <= kClassFoot && c != kClassHip) pose->stretch[i] = {limb, across};
  }
}

}  // namespace

size_t PoseBody::bones() const {
  return static_cast<size_t>(
      std::count_if(target.joints.begin(), target.joints.end(), [](const TargetJoint& j) { return !j.tip; }));
}

Vector3d PoseBody::direction(size_t joint) const {
  if (kids[joint].empty()) return Vector3d::Zero();
  Vector3d mean = Vector3d::Zero();
  for (const uint32_t k : kids[joint]) mean += vec(joints[k]);
  return mean / static_cast<double>(kids[joint].size()) - vec(joints[joint]);
}

RigPose mild_pose(const PoseBody& body, double strength, Random* random) {
  const bool symmetric = random->uniform() < 0.7;
  return draw_pose(body, strength, symmetric, 0.3, mild_sigma, random);
}

RigPose wide_pose(const PoseBody& body, double strength, Random* random) {
  const bool symmetric = random->uniform() < 0.25;
  RigPose pose = draw_pose(body, strength, symmetric, 0.25, wide_sigma, random);
  if (random->uniform() < 0.4) lower_arms(body, random, &pose);
  if (random->uniform() < 0.4) move_legs(body, random, &pose);
  if (random->uniform() < 0.2) make_toy(body, random, &pose);
  const bool four = walks_on_arms(body);
  if (random->uniform() < (four ? 0.25 : 0.12)) (four ? rest_on_floor : hold_hands)(body, random, &pose);
  if (random->uniform() < 0.35) fold_wings(body, random, &pose);
  if (random->uniform() < 0.25) curl(body, random, &pose);
  return pose;
}

}  // namespace sinew
