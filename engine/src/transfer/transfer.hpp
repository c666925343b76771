// SPDX-License-Identifier: MIT
// A whole transfer: from two meshes and the rows of one to the rows of the other.
#ifndef SINEW_TRANSFER_TRANSFER_HPP
#define SINEW_TRANSFER_TRANSFER_HPP

#include "transfer/plan.hpp"

namespace sinew::transferring {

// Runs the stages of a plan and writes the outputs at the end. Arguments as in sinew_transfer(), checked but for what the arrays
// hold. With a measuring arena only the memory is counted.
//   outputs  the library's own struct, with the caller's arrays
sinew_status run_transfer(const TransferPlan& plan, const TransferInput& input, Arena& arena,
                          sinew_transfer_outputs* outputs);

}  // namespace sinew::transferring
#endif
