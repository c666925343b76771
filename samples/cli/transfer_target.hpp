// SPDX-License-Identifier: MIT
// A target of sinew transfer: its mesh, its skeleton wherever that comes from, and which of its joints stands for which.
#ifndef SINEW_CLI_TRANSFER_TARGET_HPP
#define SINEW_CLI_TRANSFER_TARGET_HPP

#include <memory>
#include <string>

#include "sinew_character/find_joint_map.hpp"
#include "sinew_formats/character.hpp"
#include "support.hpp"

namespace sinew::cli {

// Where the targets' skeletons and the maps of joints come from.
struct TargetSource {
  std::string skeleton;   // --skeleton, or empty: the target's own, the one beside it, else the source's
  std::string map;        // --map, or empty: by names
  std::string rig_model;  // for a target without any skeleton
  bool garment = false;   // the source's skeleton as it is
  bool z_up = false;
};

struct TransferTarget {
  Character character;  // with joints; its own weights where it has some for these joints
  JointMapping mapping;
  std::string skeleton;  // whose skeleton it is, for the summary
  std::string mapped_by;
  bool fitted = false;
};

class TargetReader {
 public:
  TargetReader(const Character& source, const TargetSource& from) : source_(source), from_(from) {}
  // Throws Error.
  TransferTarget read(const std::string& path);

 private:
  void fit_source_skeleton(Character* character);

  const Character& source_;
  const TargetSource& from_;
  std::unique_ptr<LoadedModel> rig_model_;
};

}  // namespace sinew::cli
#endif
