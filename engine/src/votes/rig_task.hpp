// SPDX-License-Identifier: MIT
// The "rig" network: what it reads and what its output means.
#ifndef SINEW_VOTES_RIG_TASK_HPP
#define SINEW_VOTES_RIG_TASK_HPP

#include "model/task.hpp"
#include "votes/joint_class.hpp"
#include "votes/rig_points.hpp"

namespace sinew::rigging {

constexpr uint32_t kRigFeatureSet = 1;
constexpr uint32_t kHandsFeatureSet = 2;  // the same of a hand's crop; classes are those of hand_class.hpp
constexpr uint32_t kSlotsFeatureSet = 3,
                   kConnectionsFeatureSet = 4;  // of published/joint_slots.hpp; files hold both networks

// Channels of the output, Q10. Folded, as the features are.
enum RigOutput : uint32_t {
  kRigStart = 0,        // 3: from m to the bone's start, 16 times the share of the side
  kRigEnd = 3,          // 3: from m to its end
  kRigStartSpread = 6,  // log2 of how far off the start may be, share of the side
  kRigEndSpread = 7,
  kRigStartClass = 8,                             // 18 logits, log2
  kRigEndClass = kRigStartClass + kJointClasses,  // 19
  kRigOutputs = kRigEndClass + kEndClasses
};
constexpr int kRigOffsetScale = 16;
constexpr int32_t kRigLeastSpread = -9;  // log2; spreads are between this and 0

inline bool rig_task(uint32_t feature_set, ModelTask* task) {
  if (feature_set != kRigFeatureSet && feature_set != kHandsFeatureSet) return false;
  *task = ModelTask();
  task->id = kTaskRig;
  task->input_count = 1;
  task->inputs[0] = {input_name("pnts"), {Domain::kVertex, static_cast<uint16_t>(kRigChannels)}};
  task->output = {Domain::kVertex, static_cast<uint16_t>(kRigOutputs)};
  task->far_neighbors = true;
  return true;
}

}  // namespace sinew::rigging
#endif
