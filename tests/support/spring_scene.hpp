// SPDX-License-Identifier: MIT
// A pole with a head, chains that hang from it, and poses of it: what tests of springs move.
#ifndef SINEW_TESTS_SUPPORT_SPRING_SCENE_HPP
#define SINEW_TESTS_SUPPORT_SPRING_SCENE_HPP

#include <cmath>
#include <cstdint>
#include <vector>

#include "motion/quaternion.hpp"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace sinew_test {

using sinew::Vec3d;
using sinew::motion::Quat;

inline double distance(Vec3d a, Vec3d b) { return std::sqrt(sinew::dot(a - b, a - b)); }
inline Quat about(Vec3d axis, double radians) {
  const Vec3d a = std::sin(radians / 2) * sinew::unit(axis);
  return {a.x, a.y, a.z, std::cos(radians / 2)};
}

// Joint 0 at the origin, joint 1 a meter above it, then chains that hang on joint 1.
struct SpringScene {
  std::vector<float> positions = {0, 0, 0, 0, 1, 0};
  std::vector<int32_t> parents = {-1, 0};
  std::vector<sinew_spring_joint> joints;
  std::vector<sinew_spring_chain> chains;
  std::vector<sinew_spring_collider> colliders;
  std::vector<uint32_t> chain_colliders;
  std::vector<float> hinges;  // [joints x 3], or empty

  // `count` joints from `from`, each `step` further.
  void add_chain(Vec3d from, Vec3d step, uint32_t count, sinew_spring_joint like, int32_t parent = 1) {
    sinew_spring_chain chain = {static_cast<uint32_t>(joints.size()), count, 0, 0, -1};
    for (uint32_t i = 0; i < count; ++i) {
      const Vec3d p = from + static_cast<double>(i) * step;
      positions.insert(positions.end(), {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      parents.push_back(parent);
      parent = static_cast<int32_t>(parents.size()) - 1;
      like.joint = static_cast<uint32_t>(parent);
      joints.push_back(like);
    }
    chains.push_back(chain);
  }
  // All chains are pushed by all colliders.
  void share_colliders() {
    chain_colliders.clear();
    for (uint32_t c = 0; c < colliders.size(); ++c) chain_colliders.push_back(c);
    for (sinew_spring_chain& chain : chains) chain.collider_count = static_cast<uint32_t>(colliders.size());
  }
  uint32_t count() const { return static_cast<uint32_t>(parents.size()); }
  sinew_skeleton skeleton() const { return skeleton_of(positions.data(), parents.data(), count()); }
  sinew_spring_set set() const {
    sinew_spring_set set = SINEW_INIT(sinew_spring_set);
    set.joint_count = static_cast<uint32_t>(joints.size());
    set.chain_count = static_cast<uint32_t>(chains.size());
    set.collider_count = static_cast<uint32_t>(colliders.size());
    set.chain_collider_count = static_cast<uint32_t>(chain_colliders.size());
    set.joints = joints.data();
    set.chains = chains.data();
    set.colliders = colliders.data();
    set.chain_colliders = chain_colliders.data();
    if (!hinges.empty()) set.hinges = hinges.data();
    return set;
  }
  // The rest pose, its root moved and its second joint turned.
  void pose(Vec3d root, Quat head, std::vector<float>* rotations, std::vector<float>* translations) const {
    rotations->assign(size_t{4} * count(), 0);
    translations->assign(size_t{3} * count(), 0);
    for (size_t j = 0; j < count(); ++j) {
      (*rotations)[4 * j + 3] = 1;
      for (size_t c = 0; c < 3; ++c)
        (*translations)[3 * j + c] =
            positions[3 * j + c] - (parents[j] < 0 ? 0 : positions[3 * static_cast<size_t>(parents[j]) + c]);
    }
    const double at[3] = {root.x, root.y, root.z}, turn[4] = {head.x, head.y, head.z, head.w};
    for (size_t c = 0; c < 3; ++c) (*translations)[c] = static_cast<float>(at[c]);
    for (size_t c = 0; c < 4; ++c) (*rotations)[4 + c] = static_cast<float>(turn[c]);
  }
  // Joints in the world.
  std::vector<Vec3d> worlds(const std::vector<float>& rotations, const std::vector<float>& translations) const {
    std::vector<Vec3d> at(count());
    std::vector<Quat> turns(count());
    for (size_t j = 0; j < count(); ++j) {
      const float *const q = &rotations[4 * j], *const t = &translations[3 * j];
      const Quat own = {double{q[0]}, double{q[1]}, double{q[2]}, double{q[3]}};
      const Vec3d p = {double{t[0]}, double{t[1]}, double{t[2]}};
      const size_t parent = static_cast<size_t>(parents[j]);
      at[j] = parents[j] < 0 ? p : at[parent] + sinew::motion::rotate(turns[parent], p);
      turns[j] = parents[j] < 0 ? own : turns[parent] * own;
    }
    return at;
  }
};

inline sinew_spring_joint spring_joint(float stiffness, float gravity, float drag, float hit_radius = 0,
                                       float limit = 0) {
  return {0, hit_radius, stiffness, gravity, {0, -1, 0}, drag, limit};
}

}  // namespace sinew_test
#endif
