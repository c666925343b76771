// SPDX-License-Identifier: MIT
// Reads targets, gives those without a skeleton the source's, and maps joints.
#include "transfer_target.hpp"

#include <algorithm>
#include <filesystem>

#include "rig_skeleton.hpp"
#include "sinew_character/map_skeleton.hpp"
#include "sinew_character/predict_skeleton.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"

namespace sinew::cli {
namespace {

bool has_rig_beside(const std::string& path) {
  std::error_code ignored;
  return has_extension(path, ".obj") && std::filesystem::exists(rig_path_beside(path), ignored);
}

}  // namespace

// The source's skeleton in the place of the one that is predicted for the mesh.
void TargetReader::fit_source_skeleton(Character* character) {
  if (rig_model_ == nullptr) rig_model_ = load_model(from_.rig_model, ModelUse::kRig);
  SkeletonOptions predict;
  predict.model = &rig_model_->model;
  predict.up_axis = from_.z_up ? 1 : 0;
  const PredictedSkeleton predicted = predict_skeleton(*character, predict);
  FitOptions fit;
  fit.up_axis = from_.z_up ? 2 : 1;
  FittedSkeleton fitted;
  try {
    fitted = fit_into_mesh(source_.joints, label_skeleton(predicted), fit, *character);
  } catch (const Error& error) {
    throw Error(character->name + ": has no skeleton, and that of " + source_.name + " does not fit: " + error.what() +
                "; give one with --skeleton");
  }
  character->joints = fitted.joints;
  if (predicted.spread > kDoubtfulSpread || 2 * fitted.matched < fitted.telling)
    character->notes.push_back("warning: the skeleton of " + source_.name +
                               " was fitted to a mesh that resembles little that the model knows; look at its joints, "
                               "or give a skeleton with --skeleton");
}

TransferTarget TargetReader::read(const std::string& path) {
  TransferTarget target;
  Character& character = target.character;
  if (has_extension(path, ".txt"))
    throw UsageError(path + " is a skeleton, but a mesh is expected as a target: give its skeleton with --skeleton");
  character = read_mesh(path);
  if (from_.garment) {
    character.joints = source_.joints;
    character.influences.clear();
    target.skeleton = source_.name;
    target.mapped_by = "the same skeleton";
    for (size_t j = 0; j < source_.joints.size(); ++j) target.mapping.push_back(static_cast<int32_t>(j));
    return target;
  }
  if (!from_.skeleton.empty()) {
    read_skeleton(from_.skeleton, false, &character);
    target.skeleton = from_.skeleton;
  } else if (!character.joints.empty()) {
    target.skeleton = "its own";
  } else if (has_rig_beside(path)) {
    read_skeleton(rig_path_beside(path), true, &character);
    target.skeleton = rig_path_beside(path);
  } else {
    fit_source_skeleton(&character);
    target.skeleton = source_.name;
    target.fitted = true;
  }
  target.mapping = find_joint_map(source_, from_.map, path, character, &target.mapped_by);
  return target;
}

}  // namespace sinew::cli
