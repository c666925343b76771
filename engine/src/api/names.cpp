// SPDX-License-Identifier: MIT
// The C API: argument checks of what names say.
#include "sinew/names.h"

#include "api/arguments.hpp"
#include "core/struct_size.hpp"
#include "names/joint_name.hpp"
#include "names/named_joints.hpp"
#include "names/standard_names.hpp"

static_assert(sizeof(sinew_joint_verdicts) == 6 * sizeof(uint32_t) + 6 * sizeof(void*),
              "a hole in sinew_joint_verdicts");

extern "C" {

sinew_status sinew_joint_classes_workspace_size(uint32_t joint_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (joint_count == 0 || joint_count > SINEW_MAX_JOINTS) return SINEW_ERROR_COUNT;
  sinew_skeleton joints = SINEW_INIT(sinew_skeleton);
  joints.joint_count = joint_count;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) {
    return sinew::names::find_joint_verdicts(joints, nullptr, arena, nullptr);
  });
}

sinew_status sinew_joint_classes(const sinew_skeleton* skeleton, const uint8_t* follows, void* workspace,
                                 size_t workspace_bytes, sinew_joint_verdicts* verdicts) {
  if (skeleton == nullptr || workspace == nullptr || verdicts == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_skeleton own;
  sinew_joint_verdicts out;
  sinew_status status = sinew::read_skeleton_counts(skeleton, &own);
  if (status == SINEW_OK) status = sinew::read_struct(verdicts, sizeof out, sizeof out, &out);
  if (status != SINEW_OK) return status;
  if (own.names == nullptr) return SINEW_ERROR_ARGUMENT;
  if (own.joint_count == 0 || own.joint_count > SINEW_MAX_JOINTS) return SINEW_ERROR_COUNT;
  for (uint32_t j = 0; j < own.joint_count && follows != nullptr; ++j) {
    if (follows[j] > SINEW_FOLLOWS_NONE) return SINEW_ERROR_ARGUMENT;
  }
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::names::find_joint_verdicts(own, follows, arena, &out);
  if (status == SINEW_OK) sinew::write_struct(&out, sizeof out, verdicts);
  return status;
}

int32_t sinew_joint_side(const char* name) { return sinew::names::read_joint_name(name).side; }

sinew_status sinew_joint_other_side(const char* name, char* other, size_t room) {
  if (name == nullptr || other == nullptr) return SINEW_ERROR_ARGUMENT;
  return sinew::names::other_side_name(name, other, room) ? SINEW_OK : SINEW_ERROR_WORKSPACE;
}

const char* sinew_naming_text(uint32_t naming) { return sinew::names::naming_text(naming); }

sinew_status sinew_joint_standard_name(uint32_t naming, uint32_t joint_class, int32_t side, uint32_t index,
                                       char* name) {
  if (name == nullptr || sinew_naming_text(naming) == nullptr || side < -1 || side > 1) return SINEW_ERROR_ARGUMENT;
  return sinew::names::standard_name(naming, joint_class, side, index, name) ? SINEW_OK : SINEW_ERROR_RANGE;
}

}  // extern "C"
