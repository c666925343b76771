// SPDX-License-Identifier: MIT
// Transfers the weights of a Character to another by sinew/transfer.h.
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

// [source joints] matching joint of the target, or -1.
using JointMapping = std::vector<int32_t>;

// Maps joints of the same name.
JointMapping map_joints_by_name(const std::vector<Joint>& source, const std::vector<Joint>& target);

size_t mapped_count(const JointMapping& mapping);

// Options as in sinew_transfer_options, for a target with V vertices and J joints.
struct TransferOptions {
  uint32_t method = SINEW_TRANSFER_AUTO;  // sinew_transfer_method
  const sinew_model* model = nullptr;     // null: binds by heat only
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
  std::vector<sinew_transfer_part> parts;          // all parts, by descending size
  std::vector<uint32_t> vertex_parts;              // [V]
  bool bound = false;                              // a part was rebound, by
  sinew_method bound_by = SINEW_METHOD_MODEL;
  double carried = 0, style = 0, mismatch = 0;  // see sinew_transfer_outputs; shares and differences as numbers
  uint32_t reference_count = 0;
  size_t workspace_bytes = 0, used_bytes = 0;
  double seconds = 0;  // duration of sinew_transfer()
};

// Chooses the joints of the target that may get weight: those that match a joint with weight in the source, and
// others by name. The engine itself leaves out joints that move nothing in the source.
struct TransferJoints {
  std::vector<uint8_t> flags;  // [J] SINEW_JOINT_*
  // [J] the joint itself, or for the end of a chain that moves nothing in the source the joint that gets its weight
  std::vector<uint32_t> target_of;
};
TransferJoints choose_transfer_joints(const Character& source, const Character& target, const JointMapping& mapping);

// Throws Error with a character's name and the status text, and OutOfMemory if there is no memory for the workspace.
//   mapping  [source joints] as from map_joints_by_name(), with at least one joint
TransferResult transfer(const Character& source, const Character& target, const JointMapping& mapping,
                        const TransferOptions& options);

}  // namespace sinew
#endif
