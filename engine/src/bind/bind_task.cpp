// SPDX-License-Identifier: MIT
// What bind's features look like to a network.
#include "bind/bind_task.hpp"

#include "features/features.hpp"

namespace sinew {

bool bind_task(uint32_t feature_set, ModelTask* task) {
  if ((feature_set & ~kFeatureFlags) != kFeatureSet) return false;
  if (kHasExtras && (feature_set & kAttributesFlag) != 0 && !has_published_methods()) return false;
  *task = ModelTask();
  task->id = kTaskBind;
  task->input_count = 2;
  task->inputs[kVertexInput] = {input_name("vert"),
                                {Domain::kVertex, static_cast<uint16_t>(vertex_channels(feature_set))}};
  task->inputs[kPairInput] = {input_name("pair"), {Domain::kPair, static_cast<uint16_t>(pair_channels(feature_set))}};
  task->output = {Domain::kPair, 1};
  return true;
}

}  // namespace sinew
