// SPDX-License-Identifier: MIT
// The C API: argument checks of sinew_transfer().
#include "sinew/transfer.h"

#include <stddef.h>

#include "api/arguments.hpp"
#include "core/struct_size.hpp"
#include "transfer/plan.hpp"

// The struct of the first release, 0.1.
static constexpr uint32_t kFirstTransferOutputs = offsetof(sinew_transfer_outputs, used_bytes) + sizeof(size_t);
static_assert(sizeof(sinew_transfer_options) == 10 * sizeof(uint32_t) + 6 * sizeof(void*),
              "a hole in sinew_transfer_options");
static_assert(sizeof(sinew_transfer_outputs) == 8 * sizeof(uint32_t) + 6 * sizeof(void*),
              "a hole in sinew_transfer_outputs");
static_assert(sizeof(sinew_transfer_part) == 8 * sizeof(uint32_t), "sinew_transfer_part never changes");

namespace {

// The caller's structs with skeletons of this library's version.
struct OwnInput {
  sinew_bound_character source;
  sinew_skeleton source_skeleton, skeleton;

  explicit OwnInput(const sinew_bound_character& given) : source(given) { source.skeleton = &source_skeleton; }
  OwnInput(const OwnInput&) = delete;
  OwnInput& operator=(const OwnInput&) = delete;
  sinew_status read(decltype(sinew::read_skeleton) read_one, const sinew_bound_character& given,
                    const sinew_skeleton* target) {
    const sinew_status status = read_one(given.skeleton, &source_skeleton);
    return status == SINEW_OK ? read_one(target, &skeleton) : status;
  }
};

}  // namespace

extern "C" {

sinew_status sinew_transfer_workspace_size(const sinew_model* model, const sinew_bound_character* source,
                                           const sinew_mesh* target, const sinew_skeleton* skeleton,
                                           const sinew_transfer_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (source == nullptr || source->mesh == nullptr || source->skeleton == nullptr || target == nullptr ||
      skeleton == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  OwnInput own_input(*source);
  sinew_status status = own_input.read(sinew::read_skeleton_counts, *source, skeleton);
  if (status != SINEW_OK) return status;
  const sinew::transferring::TransferInput input = {own_input.source, *target, own_input.skeleton};
  sinew::transferring::TransferPlan plan;
  status = sinew::transferring::plan_transfer(model, input, options, &plan);
  if (status != SINEW_OK) return status;
  return sinew::measure(
      size_bytes, [&](sinew::Arena& arena) { return sinew::transferring::run_transfer(plan, input, arena, nullptr); });
}

sinew_status sinew_transfer(const sinew_model* model, const sinew_bound_character* source, const sinew_mesh* target,
                            const sinew_skeleton* skeleton, const sinew_transfer_options* options, void* workspace,
                            size_t workspace_bytes, sinew_transfer_outputs* outputs) {
  if (source == nullptr || !sinew::is_mesh(source->mesh) || source->skin.joint_indices == nullptr ||
      source->skin.weights == nullptr || source->joint_map == nullptr || !sinew::is_mesh(target) ||
      workspace == nullptr || outputs == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_transfer_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstTransferOutputs, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.joint_indices == nullptr || own.weights == nullptr || (own.part_capacity > 0 && own.parts == nullptr))
    return SINEW_ERROR_ARGUMENT;
  OwnInput own_input(*source);
  status = own_input.read(sinew::read_skeleton, *source, skeleton);
  if (status != SINEW_OK) return status;
  const sinew::transferring::TransferInput input = {own_input.source, *target, own_input.skeleton};
  sinew::transferring::TransferPlan plan;
  status = sinew::transferring::plan_transfer(model, input, options, &plan);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::transferring::run_transfer(plan, input, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

}  // extern "C"
