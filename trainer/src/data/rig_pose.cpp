// SPDX-License-Identifier: MIT
// Rotations by class of joint, arms along the body, legs on their way.
#include "data/rig_pose.hpp"

#include <algorithm>
#include <cmath>

#include "data/eigen_points.hpp"

namespace sinew {
namespace {

using namespace rigging;

using Eigen::Vector3d;

// How far joints of a class turn, standard deviation in radians.
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

// What stands out to the side hangs down.
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

// About x: less than 0 brings what hangs down forward, more than 0 bends a knee. Of a chain of one class the first joint.
void move_legs(const PoseBody& body, Random* random, RigPose* pose) {
  const bool four = walks_on_arms(body);
  const Legs legs = four ? Legs::kGallop : random->uniform() < 0.6 ? Legs::kWalk : Legs::kSit;
  const double swing = random->uniform(0.2, 0.7), bend = random->uniform(0.6, 1.4), seat = random->uniform(0.8, 1.5);
  for (size_t i = 0; i < body.bones(); ++i) {
    const JointClass c = body.target.joints[i].joint_class;
    const bool upper = c == kClassThigh || (four && c == kClassUpperArm);
    const bool lower = c == kClassCalf || (four && c == kClassForearm);
    const int parent = body.target.joints[i].parent;
    if ((!upper && !lower) || body.direction(i).y() > -1e-6) continue;
    if (parent >= 0 && body.target.joints[static_cast<size_t>(parent)].joint_class == c) continue;
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
  return pose;
}

}  // namespace sinew
