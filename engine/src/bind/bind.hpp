// SPDX-License-Identifier: MIT
// A whole bind: the stages one after the other, from the caller's mesh to the caller's rows.
#ifndef SINEW_BIND_BIND_HPP
#define SINEW_BIND_BIND_HPP

#include "bind/plan.hpp"

namespace sinew {

// Runs the stages of a plan in the workspace and writes the outputs. Arguments as in sinew_bind(), checked but for what
// the arrays hold. Nothing is written to the outputs before nothing can fail any more.
//   outputs  the library's own struct, with the caller's arrays
sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, sinew_bind_outputs* outputs);
// Takes from a measuring arena what run_bind() takes of its workspace. Asks neither for the processor nor for progress.
void measure_bind(Arena& arena, const BindPlan& plan);

}  // namespace sinew
#endif
