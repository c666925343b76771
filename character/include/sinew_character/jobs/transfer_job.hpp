// SPDX-License-Identifier: MIT
// The first part of `sinew transfer` for one target: finds its skeleton, and maps its joints to those of the source.
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
  Character character;  // with joints, and with its own weights if it has some for these joints
  JointMapping mapping;
  std::string skeleton;  // source of the skeleton, for the summary
  std::string mapped_by;
  bool fitted = false;
};

struct TransferTargetOptions {
  std::string path;      // the target's file, for messages
  std::string skeleton;  // source of the skeleton of `mesh`, for the summary
  std::string map;       // a map file; empty: by names, else by anatomy
  bool garment = false;  // uses the source's skeleton unchanged
  Axis up_axis = Axis::kY;
  std::function<const sinew_model*()> rig_model;  // called for a mesh without a skeleton, which gets the source's
};

// Throws Error.
TransferTarget transfer_target(const Character& source, Character mesh, const TransferTargetOptions& options);

}  // namespace sinew
#endif
