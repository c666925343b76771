// SPDX-License-Identifier: MIT
// A target of sinew transfer from its file.
#ifndef SINEW_CLI_TRANSFER_TARGET_HPP
#define SINEW_CLI_TRANSFER_TARGET_HPP

#include <memory>
#include <string>

#include "sinew_character/jobs/transfer_job.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew::cli {

// Where the targets' skeletons and the maps of joints come from.
struct TargetSource {
  std::string skeleton;   // --skeleton, or empty: the target's own, the one beside it, else the source's
  std::string map;        // --map, or empty: by names
  std::string rig_model;  // for a target without any skeleton
  bool garment = false;   // the source's skeleton as it is
  Axis up_axis = Axis::kY;
};

class TargetReader {
 public:
  TargetReader(const Character& source, const TargetSource& from) : source_(source), from_(from) {}
  // Throws Error.
  TransferTarget read(const std::string& path);

 private:
  const Character& source_;
  const TargetSource& from_;
  std::unique_ptr<LoadedModel> rig_model_;
};

}  // namespace sinew::cli
#endif
