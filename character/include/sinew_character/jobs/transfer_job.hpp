// SPDX-License-Identifier: MIT
// What `sinew transfer` does with one target before weights are carried: its skeleton wherever that comes from, and which of its joints
// stands for which.
#ifndef SINEW_CHARACTER_TRANSFER_JOB_HPP
#define SINEW_CHARACTER_TRANSFER_JOB_HPP

#include <functional>
#include <string>

#include "sinew_character/bind/transfer.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct TransferTarget {
  Character character;  // with joints; its own weights where it has some for these joints
  JointMapping mapping;
  std::string skeleton;  // whose skeleton it is, for the summary
  std::string mapped_by;
  bool fitted = false;
};

struct TransferTargetOptions {
  std::string path;      // the target's file, for messages
  std::string skeleton;  // whose skeleton `mesh` has, for the summary
  std::string map;       // a map's file; empty: by names, else by anatomy
  bool garment = false;  // the source's skeleton as it is
  Axis up_axis = Axis::kY;
  std::function<const sinew_model*()> rig_model;  // asked for a mesh without a skeleton, which gets the source's
};

// Throws Error.
TransferTarget transfer_target(const Character& source, Character mesh, const TransferTargetOptions& options);

}  // namespace sinew
#endif
