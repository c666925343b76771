// SPDX-License-Identifier: MIT
// Chains of a file as the engine's chains.
#include "sinew_character/springs/spring_player.hpp"

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

void copy_point(const Point3& from, float (&to)[3]) {
  for (size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(from[c]);
}

}  // namespace

SpringPlayer::SpringPlayer(const Springs& springs, const Motion& motion)
    : name_(motion.name), joint_count_(motion.joints.size()) {
  if (springs.chains.empty()) throw Error(name_ + ": has no chains that swing");
  read(springs, rest_joints(motion));
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
  skeleton.positions = positions_.data();
  skeleton.parents = parents_.data();
  skeleton.joint_count = static_cast<uint32_t>(parents_.size());
  sinew_spring_set set = SINEW_INIT(sinew_spring_set);
  set.joint_count = static_cast<uint32_t>(heads_.size());
  set.chain_count = static_cast<uint32_t>(chains_.size());
  set.collider_count = static_cast<uint32_t>(colliders_.size());
  set.chain_collider_count = static_cast<uint32_t>(chain_colliders_.size());
  set.joints = heads_.data();
  set.chains = chains_.data();
  set.colliders = colliders_.data();
  set.chain_colliders = chain_colliders_.data();
  set.hinges = hinges_.data();
  check(springs_.make(skeleton, set));
  rotations_.assign(4 * parents_.size(), 0);
  translations_.assign(3 * parents_.size(), 0);
}

void SpringPlayer::check(sinew_status status) const {
  if (status != SINEW_OK) throw Error(name_ + ": cannot play its springs: " + sinew_status_text(status));
}

void SpringPlayer::add_joint(const Point3& position, int parent) {
  for (const double x : position) positions_.push_back(static_cast<float>(x));
  parents_.push_back(parent);
}

void SpringPlayer::read(const Springs& springs, const std::vector<Joint>& joints) {
  for (const Joint& joint : joints) add_joint(point(joint.position), joint.parent);
  for (const SpringCollider& c : springs.colliders) {
    sinew_spring_collider made = {};
    made.joint = static_cast<uint32_t>(c.joint);
    made.shape = c.shape == ColliderShape::kSphere          ? SINEW_COLLIDER_SPHERE
                 : c.shape == ColliderShape::kCapsule       ? SINEW_COLLIDER_CAPSULE
                 : c.shape == ColliderShape::kInsideSphere  ? SINEW_COLLIDER_INSIDE_SPHERE
                 : c.shape == ColliderShape::kInsideCapsule ? SINEW_COLLIDER_INSIDE_CAPSULE
                                                            : SINEW_COLLIDER_PLANE;
    copy_point(c.offset, made.offset);
    copy_point(c.tail, made.tail);
    made.radius = static_cast<float>(c.radius);
    colliders_.push_back(made);
  }
  for (const SpringChain& chain : springs.chains) {
    sinew_spring_chain made = {static_cast<uint32_t>(heads_.size()), 0, static_cast<uint32_t>(chain_colliders_.size()),
                               0, chain.center};
    for (const SpringJoint& joint : chain.joints) add_head(joint);
    for (size_t i = 0; i < chain.turning_joints(); ++i) turning_.push_back(chain.joints[i].joint);
    if (chain.end) {
      const size_t last = chain.joints.back().joint;
      ends_.push_back(*chain.end);
      add_joint(point(joints[last].position) + *chain.end, static_cast<int>(last));
      SpringJoint end;
      end.joint = parents_.size() - 1;
      add_head(end);
    }
    made.joint_count = static_cast<uint32_t>(heads_.size()) - made.first_joint;
    for (const size_t group : chain.groups)
      for (const size_t c : springs.groups[group].colliders) chain_colliders_.push_back(static_cast<uint32_t>(c));
    made.collider_count = static_cast<uint32_t>(chain_colliders_.size()) - made.first_collider;
    chains_.push_back(made);
  }
}

void SpringPlayer::add_head(const SpringJoint& joint) {
  sinew_spring_joint made = {};
  made.joint = static_cast<uint32_t>(joint.joint);
  made.hit_radius = static_cast<float>(joint.hit_radius);
  made.stiffness = static_cast<float>(joint.stiffness);
  made.gravity_power = static_cast<float>(joint.gravity_power);
  copy_point(joint.gravity, made.gravity);
  made.drag = static_cast<float>(joint.drag);
  made.limit = static_cast<float>(joint.limit);
  heads_.push_back(made);
  for (const double x : joint.hinge) hinges_.push_back(static_cast<float>(x));
}

void SpringPlayer::frame(double seconds, MotionFrame* pose) {
  const size_t count = joint_count_;
  for (size_t j = 0; j < count; ++j) {
    for (size_t c = 0; c < 4; ++c) rotations_[4 * j + c] = static_cast<float>(pose->rotations[j][c]);
    for (size_t c = 0; c < 3; ++c) translations_[3 * j + c] = static_cast<float>(pose->translations[j][c]);
  }
  for (size_t e = 0; e < ends_.size(); ++e) {
    for (size_t c = 0; c < 4; ++c) rotations_[4 * (count + e) + c] = c == 3 ? 1.0f : 0.0f;
    for (size_t c = 0; c < 3; ++c) translations_[3 * (count + e) + c] = static_cast<float>(ends_[e][c]);
  }
  check(springs_.frame(static_cast<float>(seconds), rotations_.data(), translations_.data(), rotations_.data()));
  for (const size_t j : turning_) {
    Quaternion q{};
    for (size_t c = 0; c < 4; ++c) q[c] = static_cast<double>(rotations_[4 * j + c]);
    pose->rotations[j] = normalized(q);
  }
}

}  // namespace sinew
