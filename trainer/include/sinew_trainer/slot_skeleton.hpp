// SPDX-License-Identifier: MIT
// A skeleton for a bare mesh by the published method: joints in fixed slots, connections, their spanning tree. In float.
#ifndef SINEW_TRAINER_SLOT_SKELETON_HPP
#define SINEW_TRAINER_SLOT_SKELETON_HPP

#include <cstdint>
#include <string>

#include "sinew_character/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/float_network.hpp"
#include "sinew_trainer/joint_slots.hpp"

namespace sinew {

struct SlotSkeletonOptions {
  SlotCategory category = SlotCategory::kAny;  // slots of other bodies stay empty
  uint32_t up_axis = 0;                        // 0 = y, 1 = z
  bool toes = true, ends = true;
};

// The network of a checkpoint that was trained with "architecture": "slots". Throws Error naming the file.
FloatNetwork read_slot_network(const std::string& path);

// The character's own joints are not looked at. Confidences are the network's probabilities: that a slot holds a joint, and
// that the joint hangs on its parent. Nothing is mirrored, and nothing tells how doubtful the whole is (spread 0).
// workspace_bytes stays 0. Throws Error with the character's name for a mesh without faces or one that the engine refuses.
//   network  of read_slot_network()
PredictedSkeleton predict_slots(const Character& character, const FloatNetwork& network,
                                const SlotSkeletonOptions& options);

}  // namespace sinew
#endif
