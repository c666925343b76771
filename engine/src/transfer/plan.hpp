// SPDX-License-Identifier: MIT
// The caller's options of a transfer, checked and with their defaults filled in, and the binds that it takes.
#ifndef SINEW_TRANSFER_PLAN_HPP
#define SINEW_TRANSFER_PLAN_HPP

#include "bind/bind.hpp"
#include "sinew/transfer.h"

namespace sinew::transferring {

constexpr uint32_t kNothingBound = 2;  // sinew_transfer_outputs::bound_by

// The counts of meshes and skeletons that a transfer is planned for. Arrays are not read.
struct TransferInput {
  const sinew_bound_character& source;
  const sinew_mesh& target;
  const sinew_skeleton& skeleton;
};

struct TransferPlan {
  uint32_t method = SINEW_TRANSFER_AUTO;
  uint32_t influence_count = 4, weight_format = SINEW_WEIGHT_UNORM16;
  uint32_t up_axis = 0, source_up_axis = 0;
  bool garment = false, as_drawn = false;
  const uint8_t* locked = nullptr;
  const sinew_vertex_pair* pairs = nullptr;
  uint32_t pair_count = 0;
  Progress progress;
  Counts source, target, dressed;  // dressed: a garment's body and garment as one mesh
  bool with_model = false;
  // By sinew_method. For a garment there is one bind, of the dressed whole, in `target_binds`.
  BindPlan source_binds[2], target_binds[2];

  bool binds() const { return method == SINEW_TRANSFER_AUTO || method == SINEW_TRANSFER_REBIND; }
  bool matches() const { return method == SINEW_TRANSFER_AUTO || method == SINEW_TRANSFER_NEAREST; }
};

// Returns SINEW_OK, or what sinew_transfer_workspace_size() does.
sinew_status plan_transfer(const sinew_model* model, const TransferInput& input, const sinew_transfer_options* options,
                           TransferPlan* plan);

// A whole transfer: runs the stages of a plan and writes the outputs at the end. Arguments as in sinew_transfer(), checked but for what the arrays
// hold. With a measuring arena only the memory is counted.
//   outputs  the library's own struct, with the caller's arrays
sinew_status run_transfer(const TransferPlan& plan, const TransferInput& input, Arena& arena,
                          sinew_transfer_outputs* outputs);

}  // namespace sinew::transferring
#endif
