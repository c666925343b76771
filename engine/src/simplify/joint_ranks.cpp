// SPDX-License-Identifier: MIT
// Roles and classes of joints (names/) to ranks.
#include "simplify/joint_ranks.hpp"

#include "mapping/map.hpp"
#include "names/named_joints.hpp"

namespace sinew::simplifying {
namespace {

constexpr double kNoSurface = 1e-6;  // share of the whole; less is what exporters leave behind

constexpr uint32_t kMostLaid = 512;  // joints of a rig that a body is laid over; more are a crowd, and take long

bool is_limb(uint8_t c) {
  return c == SINEW_CLASS_UPPER_ARM || c == SINEW_CLASS_FOREARM || c == SINEW_CLASS_THIGH || c == SINEW_CLASS_CALF;
}

bool is_body(uint8_t c) {
  return c == SINEW_CLASS_PELVIS || c == SINEW_CLASS_SPINE || c == SINEW_CLASS_HEAD || c == SINEW_CLASS_HAND ||
         c == SINEW_CLASS_FOOT || is_limb(c);
}

// A rig without a single limb by its names: the classes of a body that fits, if all of its eight bones of limbs are found.
sinew_status classes_by_shape(const sinew_skeleton& skeleton, Arena& arena, const uint8_t* roles, uint8_t* laid,
                              uint8_t* classes) {
  const sinew_status status = mapping::find_limb_classes(skeleton, nullptr, nullptr, arena, laid);
  if (status != SINEW_OK || arena.measuring()) return status;
  uint32_t bones[SINEW_CLASS_OTHER + 1] = {};
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    if (laid[j] < SINEW_CLASS_OTHER) ++bones[laid[j]];
  }
  if (bones[SINEW_CLASS_UPPER_ARM] < 2 || bones[SINEW_CLASS_FOREARM] < 2 || bones[SINEW_CLASS_THIGH] < 2 ||
      bones[SINEW_CLASS_CALF] < 2) {
    return SINEW_OK;
  }
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    if (roles[j] == SINEW_ROLE_DEFORMS && classes[j] == SINEW_CLASS_OTHER) classes[j] = laid[j];
  }
  return SINEW_OK;
}

// Whether the joint is part of the body, and not a piece more of the part that its parent is.
bool keeps_body(const sinew_skeleton& skeleton, const uint8_t* classes, const uint8_t* roles, const uint8_t* below,
                uint32_t j) {
  if (roles[j] != SINEW_ROLE_DEFORMS || !is_body(classes[j])) return false;
  const int32_t p = skeleton.parents[j];
  const bool goes_on = p >= 0 && roles[p] == SINEW_ROLE_DEFORMS && classes[p] == classes[j];
  if (classes[j] == SINEW_CLASS_PELVIS || !goes_on) return true;
  return classes[j] == SINEW_CLASS_SPINE && below[j] == 0;
}

JointRank rank_of(uint8_t role, uint8_t joint_class) {
  switch (role) {
    case SINEW_ROLE_ROOT:
      return kRankTrunk;
    case SINEW_ROLE_CONTROL:
    case SINEW_ROLE_SLOT:
    case SINEW_ROLE_END:
    case SINEW_ROLE_TWIST:
    case SINEW_ROLE_FACE:
    case SINEW_ROLE_HELPER:
      return kRankDetail;
    case SINEW_ROLE_FINGER:
      return kRankFinger;
    default:
      break;
  }
  const bool trunk = is_body(joint_class) || joint_class == SINEW_CLASS_NECK || joint_class == SINEW_CLASS_CLAVICLE ||
                     joint_class == SINEW_CLASS_HIP;
  return trunk ? kRankTrunk : kRankPart;
}

}  // namespace

sinew_status find_joint_ranks(const sinew_skeleton& skeleton, const float* areas, Arena& arena, uint8_t* ranks,
                              uint8_t* is_end) {
  const ArenaScope scope(arena);
  const uint32_t n = skeleton.joint_count;
  uint8_t* const classes = arena.alloc<uint8_t>(n);
  uint8_t* const roles = arena.alloc<uint8_t>(n);
  uint8_t* const laid = arena.alloc<uint8_t>(n);  // classes of the body that is laid over; a spine goes on below
  uint8_t* const follows = arena.alloc<uint8_t>(n);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  sinew_joint_verdicts verdicts = SINEW_INIT(sinew_joint_verdicts);
  if (!arena.measuring()) {
    double whole = 0;
    for (uint32_t j = 0; j < n && areas != nullptr; ++j) whole += static_cast<double>(areas[j]);
    for (uint32_t j = 0; j < n; ++j) {
      follows[j] = areas != nullptr && static_cast<double>(areas[j]) > kNoSurface * whole ? SINEW_FOLLOWS_SOME
                                                                                          : SINEW_FOLLOWS_NONE;
    }
    verdicts.classes = classes;
    verdicts.roles = roles;
  }
  sinew_status status = names::find_joint_verdicts(skeleton, areas != nullptr ? follows : nullptr, arena, &verdicts);
  if (status != SINEW_OK) return status;
  bool any = false;
  for (uint32_t j = 0; j < n && !arena.measuring(); ++j)
    any = any || (roles[j] == SINEW_ROLE_DEFORMS && is_limb(classes[j]));
  if (!any && n <= kMostLaid) status = classes_by_shape(skeleton, arena, roles, laid, classes);
  if (status != SINEW_OK || arena.measuring()) return status;
  for (uint32_t j = 0; j < n; ++j) laid[j] = 0;
  for (uint32_t j = 0; j < n; ++j) {
    const int32_t p = skeleton.parents[j];
    if (p >= 0 && roles[j] == SINEW_ROLE_DEFORMS && classes[j] == SINEW_CLASS_SPINE) laid[p] = 1;
  }
  for (uint32_t j = 0; j < n; ++j) {
    ranks[j] = keeps_body(skeleton, classes, roles, laid, j) ? kRankBody : rank_of(roles[j], classes[j]);
    is_end[j] = roles[j] == SINEW_ROLE_END ? 1 : 0;
  }
  return SINEW_OK;
}

}  // namespace sinew::simplifying
