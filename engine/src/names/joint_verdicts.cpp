// SPDX-License-Identifier: MIT
// Names, roles, classes, partners: in this order into the caller's arrays.
#include "names/named_joints.hpp"
#include "names/partners.hpp"

namespace sinew::names {
namespace {

bool is_one_finger(uint8_t joint_class) { return joint_class >= SINEW_CLASS_THUMB && joint_class <= SINEW_CLASS_PINKY; }

// The index of a finger's joint in the finger, by the hierarchy: names count from 0, from 1 and within other numbers.
void number_joints(const NamedJoints& s, int32_t* numbers) {
  for (int32_t i = 0; i < s.n; ++i) {
    const int32_t j = s.order[i], p = s.parents[j];
    numbers[j] = s.names[j].own_number;
    if (!is_one_finger(s.classes[j])) continue;
    numbers[j] = p >= 0 && s.classes[p] == s.classes[j] && s.names[p].side == s.names[j].side ? numbers[p] + 1 : 1;
  }
}

template <class T>
void copy(const T* from, int32_t count, T* to) {
  for (int32_t i = 0; i < count && to != nullptr; ++i) to[i] = from[i];
}

}  // namespace

sinew_status find_joint_verdicts(const sinew_skeleton& joints, const uint8_t* follows, Arena& arena,
                                 sinew_joint_verdicts* verdicts) {
  const uint32_t n = joints.joint_count;
  NamedJoints s;
  s.allocate(arena, n);
  int32_t* const no_parents = arena.alloc<int32_t>(n);
  int32_t* const partners = arena.alloc<int32_t>(n);
  int32_t* const images = arena.alloc<int32_t>(n);
  float* const scratch = arena.alloc<float>(n);
  Mirror mirror;
  mirror.images = arena.alloc<int32_t>(n);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  sinew_skeleton own = joints;
  if (own.parents == nullptr) {
    for (uint32_t j = 0; j < n; ++j) no_parents[j] = -1;
    own.parents = no_parents;
  }
  const sinew_status status = s.build(own, follows);
  if (status != SINEW_OK) return status;
  find_roles(&s);
  find_classes(&s);
  find_partners(s, partners);
  for (uint32_t j = 0; j < n; ++j) mirror.images[j] = -1;
  float planes[3] = {0, 0, 0};
  if (own.positions != nullptr) {
    for (uint32_t axis = 0; axis < 3; ++axis) planes[axis] = mirror_plane(s, partners, axis, scratch);
    find_mirror(s, partners, planes, images, &mirror);
  }
  number_joints(s, images);
  copy(s.classes, s.n, verdicts->classes);
  copy(s.roles, s.n, verdicts->roles);
  copy(images, s.n, verdicts->numbers);
  copy(partners, s.n, verdicts->partners);
  copy(mirror.images, s.n, verdicts->images);
  for (int32_t j = 0; j < s.n && verdicts->sides != nullptr; ++j) verdicts->sides[j] = s.names[j].side;
  verdicts->mirror_axis = mirror.axis;
  copy(planes, 3, verdicts->mirror_planes);
  verdicts->mirrored = mirror.exact ? 1 : 0;
  return SINEW_OK;
}

}  // namespace sinew::names
