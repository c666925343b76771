// SPDX-License-Identifier: MIT
// Random poses and proportions of a hand that fingers are learned from.
#include <Eigen/Dense>
#include <cmath>

#include "data/eigen_points.hpp"
#include "data/hand_sample.hpp"

namespace sinew {
namespace {

using namespace rigging;

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d turn(const Vector3d& by) {
  const double angle = by.norm();
  if (angle < 1e-12) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, by / angle).toRotationMatrix();
}

}  // namespace

// The transforms that move a hand into a drawn pose.
class HandSource::Motion {
 public:
  Motion(const HandSource& hand, double strength, Random* random)
      : hand_(hand),
        own_(hand.joints_.size(), Matrix3d::Identity()),
        scale_(own_),
        linear_(own_),
        origin_(hand.joints_.size(), Vector3d::Zero()) {
    find_palm();
    bend_fingers(strength, random);
    const Vector3d whole = (0.12 * strength * normals(random)).array().exp().matrix();
    const double roll = strength * (random->uniform() < 0.2 ? 0.9 : 0.25) * random->normal();
    all_ = whole.asDiagonal() * turn(roll * vec(hand.elbow_).normalized());
    std::vector<Matrix3d> rotation(own_.size(), Matrix3d::Identity());
    for (size_t j = 1; j < own_.size(); ++j) {
      const size_t p = static_cast<size_t>(hand.joints_[j].parent);
      rotation[j] = rotation[p] * own_[j];
      origin_[j] = origin_[p] + linear_[p] * (vec(hand.joints_[j].at) - vec(hand.joints_[p].at));
      linear_[j] = rotation[j] * scale_[j];
    }
  }

  Vector3d moved(size_t j, const Point3& p) const {
    return all_ * (origin_[j] + linear_[j] * (vec(p) - vec(hand_.joints_[j].at)));
  }
  Vector3d moved(size_t vertex) const {
    const Point3& p = hand_.vertices_[vertex];
    Vector3d sum = Vector3d::Zero();
    double weights = 0;
    for (const Influence& i : hand_.influences_[vertex]) {
      sum += static_cast<double>(i.weight) * moved(i.joint, p);
      weights += static_cast<double>(i.weight);
    }
    return weights > 1e-6 ? Vector3d(sum / weights) : Vector3d(all_ * vec(p));
  }
  std::optional<size_t> gone() const { return gone_; }  // a finger

 private:
  // The palm's plane, and to which side fingers bend.
  void find_palm() {
    const std::vector<HandFinger>& fingers = hand_.fingers_;
    const std::vector<HandJoint>& joints = hand_.joints_;
    along_ = vec(hand_.palm_end_).normalized();
    Vector3d across = Vector3d(0, 0, 1);
    if (fingers.size() > 2) across = vec(joints[fingers[1].joints[0]].at) - vec(joints[fingers.back().joints[0]].at);
    normal_ = across.cross(along_);
    if (normal_.norm() < 1e-9) normal_ = Vector3d(0, 1, 0);
    normal_.normalize();
    double bent = 0;
    for (const HandFinger& f : fingers) {
      if (f.finger == 0 || f.joints.size() < 2 || !f.end) continue;
      const Vector3d base = vec(joints[f.joints[0]].at), middle = vec(joints[f.joints[1]].at);
      bent += normal_.dot((vec(*f.end) - middle).normalized() - (middle - base).normalized());
    }
    if (bent > 0) normal_ = -normal_;  // away from where they bend
    bend_axis_ = normal_.cross(along_).normalized();
  }

  void bend_fingers(double strength, Random* random) {
    const std::vector<HandFinger>& fingers = hand_.fingers_;
    const double curl =
        strength * (random->uniform() < 0.25 ? std::abs(0.5 * random->normal()) : 0.2 * random->normal());
    const double longer = 0.15 * strength * random->normal(), thicker = 0.12 * strength * random->normal();
    const double spread = 0.1 * strength * random->normal();
    if (fingers.size() == 5 && random->uniform() < 0.2 * strength) gone_ = static_cast<size_t>(2 + random->below(3));
    own_[kWrist] = turn(0.2 * strength * normals(random));
    for (size_t i = 0; i < fingers.size(); ++i) {
      const HandFinger& f = fingers[i];
      const double s = std::exp(longer + 0.08 * strength * random->normal()), r = std::exp(thicker);
      for (size_t k = 0; k < f.joints.size(); ++k) {
        const uint32_t j = f.joints[k];
        Vector3d by = 0.08 * strength * normals(random);
        if (f.finger == 0) {
          if (k == 0) by *= 3;
        } else {
          by += (curl + 0.1 * strength * random->normal()) * bend_axis_;
          if (k == 0)
            by += (spread * (static_cast<double>(f.finger) - 2.5) + 0.05 * strength * random->normal()) * normal_;
        }
        own_[j] = turn(by);
        const Vector3d bone = bone_of(f, k);
        scale_[j] = r * Matrix3d::Identity() + (s - r) * bone * bone.transpose();
        if (gone_ == i) scale_[j] = 1e-3 * Matrix3d::Identity();
      }
    }
  }

  // The direction of a finger's k-th bone.
  Vector3d bone_of(const HandFinger& f, size_t k) const {
    const Vector3d at = vec(hand_.joints_[f.joints[k]].at);
    const Vector3d next = k + 1 < f.joints.size() ? vec(hand_.joints_[f.joints[k + 1]].at)
                          : f.end                 ? vec(*f.end)
                                                  : at + along_;
    return (next - at).normalized();
  }

  const HandSource& hand_;
  std::vector<Matrix3d> own_, scale_, linear_;  // [joints_]
  std::vector<Vector3d> origin_;                // [joints_]
  Vector3d along_, normal_, bend_axis_;
  Matrix3d all_;
  std::optional<size_t> gone_;
};

HandSource::Posed HandSource::pose(uint64_t seed, double strength) const {
  Posed posed;
  posed.vertices = vertices_;
  for (const HandJoint& j : joints_) {
    posed.joints.push_back(j.at);
    posed.classes.push_back(j.hand_class);
  }
  for (const HandFinger& f : fingers_) posed.ends.push_back(f.end);
  posed.palm_end = palm_end_;
  if (strength <= 0) return posed;
  Random random(seed);
  const Motion motion(*this, strength, &random);
  for (size_t v = 0; v < vertices_.size(); ++v) posed.vertices[v] = arr(motion.moved(v));
  for (size_t j = 0; j < joints_.size(); ++j) posed.joints[j] = arr(motion.moved(j, joints_[j].at));
  for (size_t i = 0; i < fingers_.size(); ++i)
    if (fingers_[i].end) posed.ends[i] = arr(motion.moved(fingers_[i].joints.back(), *fingers_[i].end));
  posed.palm_end = arr(motion.moved(kWrist, palm_end_));
  if (motion.gone()) {  // four fingers are thumb, index, middle and pinky
    const size_t gone = *motion.gone();
    for (const uint32_t j : fingers_[gone].joints) posed.classes[j] = kHandPalm;
    posed.ends[gone].reset();
    constexpr uint32_t kThree[3] = {1, 2, 4};
    uint32_t next = 0;
    for (size_t i = 1; i < fingers_.size(); ++i) {
      if (i == gone) continue;
      for (size_t k = 0; k < fingers_[i].joints.size(); ++k)
        posed.classes[fingers_[i].joints[k]] = finger_class(kThree[next], static_cast<uint32_t>(k));
      ++next;
    }
  }
  return posed;
}

}  // namespace sinew
