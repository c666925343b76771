// SPDX-License-Identifier: MIT
// Weights of one Character go to another through sinew/transfer.h.
#ifndef SINEW_CHARACTER_TRANSFER_HPP
#define SINEW_CHARACTER_TRANSFER_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// [source joints] the target's joint that stands for it, or -1.
using JointMapping = std::vector<int32_t>;

// Joints of the same name.
JointMapping map_joints_by_name(const std::vector<Joint>& source, const std::vector<Joint>& target);

size_t mapped_count(const JointMapping& mapping);

// What sinew_transfer_options says, for a target of V vertices and J joints.
struct TransferOptions {
  uint32_t method = SINEW_TRANSFER_AUTO;  // sinew_transfer_method
  const sinew_model* model = nullptr;     // null: binds are by heat alone
  uint32_t influence_count = 4;
  Axis up_axis = Axis::kY, source_up_axis = Axis::kY;
  bool garment = false, as_drawn = false;
  std::vector<sinew_vertex_pair> pairs;
  std::vector<uint8_t> locked;  // [V] or empty; locked rows come from target.influences
  uint32_t kernel = SINEW_KERNEL_AUTO;
  sinew_progress progress = nullptr;
  void* progress_user = nullptr;
  uint32_t thread_count = 1;
  sinew_parallel_for parallel_for = nullptr;
  void* parallel_user = nullptr;
};

struct TransferResult {
  std::vector<std::vector<Influence>> influences;  // [V]
  std::vector<uint8_t> confidence;                 // [V] see sinew_transfer_outputs
  std::vector<sinew_transfer_part> parts;          // by falling size, all of them
  std::vector<uint32_t> vertex_parts;              // [V]
  bool bound = false;                              // something was bound, by
  sinew_method bound_by = SINEW_METHOD_MODEL;
  double carried = 0, style = 0, mismatch = 0;  // see sinew_transfer_outputs; shares and differences as numbers
  uint32_t reference_count = 0;
  size_t workspace_bytes = 0, used_bytes = 0;
  double seconds = 0;  // of sinew_transfer() alone
};

// Which joints of the target may get weight: those that stand for a joint with weight in the source may whatever their names say,
// names tell of the others. What moves nothing in the source, the engine itself leaves out.
struct TransferJoints {
  std::vector<uint8_t> flags;  // [J] SINEW_JOINT_*
  // [J] itself, or for the end of a chain that moves nothing in the source the joint that takes its weight
  std::vector<uint32_t> target_of;
};
TransferJoints choose_transfer_joints(const Character& source, const Character& target, const JointMapping& mapping);

// Throws Error with a character's name and the status' text, and OutOfMemory when there is no memory for the workspace.
//   mapping  [source joints] as map_joints_by_name() gives it, with at least one joint
TransferResult transfer(const Character& source, const Character& target, const JointMapping& mapping,
                        const TransferOptions& options);

}  // namespace sinew
#endif
