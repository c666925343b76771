// SPDX-License-Identifier: MIT
// The C API: argument checks of sinew_map().
#include "mapping/map.hpp"

#include "api/arguments.hpp"
#include "core/struct_size.hpp"
#include "sinew/map.h"
#include "sinew/names.h"

static_assert(sizeof(sinew_map_options) == 6 * sizeof(uint32_t) + 4 * sizeof(void*), "a hole in sinew_map_options");
static_assert(sizeof(sinew_map_outputs) == 4 * sizeof(uint32_t) + 4 * sizeof(void*), "a hole in sinew_map_outputs");

extern "C" {

sinew_status sinew_map_workspace_size(uint32_t target_count, uint32_t source_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (target_count == 0 || target_count > SINEW_MAX_JOINTS || source_count == 0 || source_count > SINEW_MAX_JOINTS)
    return SINEW_ERROR_COUNT;
  sinew::mapping::MapPlan plan = {};
  plan.target.joint_count = target_count;
  plan.source.joint_count = source_count;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) { return sinew::mapping::run_map(plan, arena, nullptr); });
}

sinew_status sinew_map(const sinew_skeleton* target, const sinew_skeleton* source, const sinew_map_options* options,
                       void* workspace, size_t workspace_bytes, sinew_map_outputs* outputs) {
  if (target == nullptr || source == nullptr || workspace == nullptr || outputs == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_map_outputs own;
  sinew_status status = sinew::read_struct(outputs, sizeof own, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.sources == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::mapping::MapPlan plan;
  status = sinew::mapping::plan_map(target, source, options, &plan);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::mapping::run_map(plan, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_limb_classes_workspace_size(uint32_t target_count, uint32_t source_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (target_count == 0 || target_count > SINEW_MAX_JOINTS || source_count > SINEW_MAX_JOINTS) return SINEW_ERROR_COUNT;
  sinew_skeleton target = SINEW_INIT(sinew_skeleton), source = SINEW_INIT(sinew_skeleton);
  target.joint_count = target_count;
  source.joint_count = source_count;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) {
    return sinew::mapping::find_limb_classes(target, source_count > 0 ? &source : nullptr, nullptr, arena, nullptr);
  });
}

sinew_status sinew_limb_classes(const sinew_skeleton* target, const sinew_skeleton* source, const int32_t* sources,
                                void* workspace, size_t workspace_bytes, uint8_t* classes) {
  if (target == nullptr || workspace == nullptr || classes == nullptr || (source == nullptr) != (sources == nullptr))
    return SINEW_ERROR_ARGUMENT;
  sinew::mapping::MapPlan plan;
  const sinew_status status = sinew::mapping::plan_map(target, source != nullptr ? source : target, nullptr, &plan);
  if (status != SINEW_OK) return status;
  for (uint32_t j = 0; j < plan.target.joint_count && sources != nullptr; ++j) {
    if (sources[j] < -1 || sources[j] >= static_cast<int32_t>(plan.source.joint_count)) return SINEW_ERROR_RANGE;
  }
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::mapping::find_limb_classes(plan.target, source != nullptr ? &plan.source : nullptr, sources, arena,
                                           classes);
}

}  // extern "C"
