// SPDX-License-Identifier: MIT
// Which bones are arms and legs: by their names, else by those of their sources, else where a human body has its own.
#include "mapping/human_body.hpp"
#include "mapping/map.hpp"
#include "names/named_joints.hpp"
#include "names/standard_names.hpp"
#include "sinew/published.h"

namespace sinew::mapping {
namespace {

bool is_limb(uint8_t c) {
  return c == SINEW_CLASS_UPPER_ARM || c == SINEW_CLASS_FOREARM || c == SINEW_CLASS_THIGH || c == SINEW_CLASS_CALF;
}

// OTHER for what names do not tell, for ends and details of a body.
sinew_status read_classes(const sinew_skeleton& rig, Arena& arena, uint8_t* classes) {
  const ArenaScope scope(arena);
  uint8_t* const roles = arena.alloc<uint8_t>(rig.joint_count);
  sinew_joint_verdicts verdicts = SINEW_INIT(sinew_joint_verdicts);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (!arena.measuring()) {
    for (uint32_t j = 0; j < rig.joint_count; ++j) classes[j] = SINEW_CLASS_OTHER;
    if (rig.names == nullptr) return SINEW_OK;
    verdicts.classes = classes;
    verdicts.roles = roles;
  }
  const sinew_status status = names::find_joint_verdicts(rig, nullptr, arena, &verdicts);
  if (status != SINEW_OK || arena.measuring()) return status;
  for (uint32_t j = 0; j < rig.joint_count; ++j) {
    const bool known = roles[j] == SINEW_ROLE_DEFORMS || roles[j] == SINEW_ROLE_ROOT;
    if (!known || classes[j] > SINEW_CLASS_OTHER) classes[j] = SINEW_CLASS_OTHER;
  }
  return SINEW_OK;
}

// An arm that is called shoulder, arm and hand has no forearm by its names. Where the map found the shoulder to be the upper arm and the arm the forearm, they are.
void take_shoulders_as_arms(const sinew_skeleton& target, const int32_t* sources, const uint8_t* theirs,
                            uint8_t* classes) {
  const auto moves_as = [&](uint32_t j, uint8_t joint_class) {
    return sources[j] >= 0 && theirs[sources[j]] == joint_class;
  };
  const auto is_below = [&](uint32_t j, uint32_t above) {
    for (int32_t at = target.parents[j]; at >= 0; at = target.parents[at])
      if (at == static_cast<int32_t>(above)) return true;
    return false;
  };
  for (uint32_t j = 0; j < target.joint_count; ++j) {
    if (classes[j] != SINEW_CLASS_CLAVICLE || !moves_as(j, SINEW_CLASS_UPPER_ARM)) continue;
    int32_t arm = -1;
    bool has_forearm = false;
    for (uint32_t k = 0; k < target.joint_count; ++k) {
      if (!is_below(k, j)) continue;
      has_forearm = has_forearm || classes[k] == SINEW_CLASS_FOREARM;
      if (classes[k] == SINEW_CLASS_UPPER_ARM && moves_as(k, SINEW_CLASS_FOREARM)) arm = static_cast<int32_t>(k);
    }
    if (has_forearm || arm < 0) continue;
    classes[j] = SINEW_CLASS_UPPER_ARM;
    classes[arm] = SINEW_CLASS_FOREARM;
  }
}

// Lays a human body over the rig.
sinew_status classes_of_body(const sinew_skeleton& target, Arena& arena, uint8_t* classes) {
  const ArenaScope scope(arena);
  float* const positions = arena.alloc<float>(size_t{3} * kHumanJoints);
  int32_t* const parents = arena.alloc<int32_t>(kHumanJoints);
  uint8_t* const ends = arena.alloc<uint8_t>(kHumanJoints);
  auto* const texts = arena.alloc<char[SINEW_JOINT_NAME_BYTES]>(kHumanJoints);
  const char** const called = arena.alloc<const char*>(kHumanJoints);
  int32_t* const sources = arena.alloc<int32_t>(target.joint_count);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  MapPlan plan = {};
  plan.target = target;
  plan.source.joint_count = kHumanJoints;
  if (arena.measuring()) return run_map(plan, arena, nullptr);
  for (uint32_t j = 0; j < kHumanJoints; ++j) {
    const BodyJoint& joint = kHumanBody[j];
    for (uint32_t i = 0; i < 3; ++i) positions[3 * j + i] = joint.position[i];
    parents[j] = joint.parent;
    ends[j] = joint.end;
    texts[j][0] = 0;
    if (joint.end == 0)
      (void)names::standard_name(SINEW_NAMING_MIXAMO, joint.joint_class, joint.side, joint.index, texts[j]);
    called[j] = texts[j];
  }
  sinew_skeleton body = SINEW_INIT(sinew_skeleton);
  body.positions = positions;
  body.parents = parents;
  body.joint_count = kHumanJoints;
  body.up = SINEW_UP_Y;
  body.names = called;
  body.ends = ends;
  const sinew_map_options options = SINEW_INIT(sinew_map_options);
  sinew_map_outputs outputs = SINEW_INIT(sinew_map_outputs);
  outputs.sources = sources;
  sinew_status status = plan_map(&target, &body, &options, &plan);
  if (status == SINEW_OK) status = run_map(plan, arena, &outputs);
  if (status != SINEW_OK || outputs.method == SINEW_MAP_BRANCHES) return status;  // no body
  for (uint32_t j = 0; j < target.joint_count; ++j) {
    if (sources[j] < 0) continue;
    const BodyJoint& joint = kHumanBody[sources[j]];
    if (joint.end == 0 && joint.joint_class < SINEW_CLASS_OTHER) classes[j] = joint.joint_class;
  }
  return SINEW_OK;
}

}  // namespace

sinew_status find_limb_classes(const sinew_skeleton& target, const sinew_skeleton* source, const int32_t* sources,
                               Arena& arena, uint8_t* classes) {
  uint8_t* const own = arena.alloc<uint8_t>(target.joint_count);
  uint8_t* const theirs = arena.alloc<uint8_t>(source != nullptr ? source->joint_count : 0);
  sinew_status status = read_classes(target, arena, own);
  if (status == SINEW_OK && source != nullptr) status = read_classes(*source, arena, theirs);
  if (status != SINEW_OK) return status;
  bool any = false;
  if (sources != nullptr && source != nullptr && !arena.measuring())
    take_shoulders_as_arms(target, sources, theirs, own);
  for (uint32_t j = 0; j < target.joint_count && !arena.measuring(); ++j) {
    if (own[j] == SINEW_CLASS_OTHER && sources != nullptr && sources[j] >= 0) own[j] = theirs[sources[j]];
    any = any || is_limb(own[j]);
  }
  if (!any) status = classes_of_body(target, arena, own);
  if (status != SINEW_OK) return status;
  for (uint32_t j = 0; j < target.joint_count && !arena.measuring(); ++j) classes[j] = own[j];
  return SINEW_OK;
}

}  // namespace sinew::mapping
