// SPDX-License-Identifier: MIT
// The task of the networks that predict skin weights: features in, logits out.
#ifndef SINEW_BIND_BIND_TASK_HPP
#define SINEW_BIND_BIND_TASK_HPP

#include "model/task.hpp"

namespace sinew {

// Vertex and pair features of that set, and one logit per pair. False for a set or a flag that this build does not have.
bool bind_task(uint32_t feature_set, ModelTask* task);

}  // namespace sinew
#endif
