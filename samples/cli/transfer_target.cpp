// SPDX-License-Identifier: MIT
// Reads targets and their skeletons.
#include "transfer_target.hpp"

#include <utility>

#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {

TransferTarget TargetReader::read(const std::string& path) {
  if (has_extension(path, ".txt"))
    throw UsageError(path + " is a skeleton, but a mesh is expected as a target; give its skeleton with --skeleton");
  Character mesh = read_mesh(path);
  TransferTargetOptions options;
  options.path = path;
  options.map = from_.map;
  options.garment = from_.garment;
  options.up_axis = from_.up_axis;
  options.rig_model = [this] {
    if (rig_model_ == nullptr) rig_model_ = load_model(from_.rig_model, ModelUse::kRig);
    return &rig_model_->model;
  };
  if (!from_.skeleton.empty()) {
    read_skeleton(from_.skeleton, false, &mesh);
    options.skeleton = from_.skeleton;
  } else if (!mesh.joints.empty()) {
    options.skeleton = "its own";
  } else if (!from_.garment && has_rig_beside(path)) {
    read_skeleton(rig_path_beside(path), true, &mesh);
    options.skeleton = rig_path_beside(path);
  }
  return transfer_target(source_, std::move(mesh), options);
}

}  // namespace sinew::cli
