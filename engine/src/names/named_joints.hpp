// SPDX-License-Identifier: MIT
// A skeleton as its names are read: hierarchy, what each name says, and the verdicts on each joint.
#ifndef SINEW_NAMES_NAMED_JOINTS_HPP
#define SINEW_NAMES_NAMED_JOINTS_HPP

#include "core/arena.hpp"
#include "names/joint_name.hpp"
#include "sinew/names.h"

namespace sinew::names {

struct NamedJoints {
  int32_t n = 0;
  const int32_t* parents = nullptr;
  const float* positions = nullptr;  // or null
  const uint8_t* follows = nullptr;  // [n] sinew_follows, or null
  const uint8_t* ends = nullptr;     // [n] or null
  JointName* names = nullptr;
  int32_t* kid_offsets = nullptr;  // [n + 2] into kids; row n holds the roots
  int32_t* kids = nullptr;
  int32_t* order = nullptr;    // parents first
  uint8_t* roles = nullptr;    // sinew_joint_role
  uint8_t* classes = nullptr;  // sinew_joint_class
  uint8_t* marks = nullptr;    // scratch

  bool allocate(Arena& arena, uint32_t joints);
  // SINEW_ERROR_INDEX, SINEW_ERROR_HIERARCHY, SINEW_ERROR_NOT_FINITE.
  sinew_status build(const sinew_skeleton& joints, const uint8_t* followed);

  bool is_leaf(int32_t j) const { return kid_offsets[j] == kid_offsets[j + 1]; }
  bool deforms(int32_t j) const { return roles[j] == SINEW_ROLE_DEFORMS; }
  bool is_end(int32_t j) const { return roles[j] == SINEW_ROLE_END; }
  bool is_bare(int32_t j) const {
    return (follows != nullptr && follows[j] == SINEW_FOLLOWS_NONE) || (ends != nullptr && ends[j] != 0);
  }
  bool has_weight(int32_t j) const { return follows != nullptr && follows[j] == SINEW_FOLLOWS_SOME; }
};

// Calls body(child) for each child in the order of their numbers.
template <class Body>
void each_kid(const NamedJoints& joints, int32_t j, const Body& body) {
  for (int32_t k = joints.kid_offsets[j]; k < joints.kid_offsets[j + 1]; ++k) body(joints.kids[k]);
}

// Into roles: what each joint is there for, but for details of a body, which find_classes() tells.
void find_roles(NamedJoints* joints);
// Into classes and roles.
void find_classes(NamedJoints* joints);

// sinew_joint_classes() behind its checks. `verdicts` is null where the arena measures. SINEW_ERROR_WORKSPACE and those of NamedJoints::build().
sinew_status find_joint_verdicts(const sinew_skeleton& joints, const uint8_t* follows, Arena& arena,
                                 sinew_joint_verdicts* verdicts);

}  // namespace sinew::names
#endif
