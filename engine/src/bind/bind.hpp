// SPDX-License-Identifier: MIT
// A whole bind: the stages one after the other, from the caller's mesh to the caller's rows.
#ifndef SINEW_BIND_BIND_HPP
#define SINEW_BIND_BIND_HPP

#include "bind/plan.hpp"

namespace sinew {

// Runs the stages of a plan in the workspace and writes the rows. Arguments as in sinew_bind(), checked but for what
// the arrays hold. Nothing is written to joints and weights before nothing can fail any more.
sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, uint16_t* joints, void* weights, size_t* used_bytes);
// Takes from a measuring arena what run_bind() takes of its workspace. Asks neither for the processor nor for progress.
void measure_bind(Arena& arena, const BindPlan& plan);

}  // namespace sinew
#endif
