// SPDX-License-Identifier: MIT
// Gives targets without a skeleton the source's, and maps joints.
#include "sinew_character/jobs/transfer_job.hpp"

#include <utility>

#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// The source's skeleton, fitted to the one that is predicted for the mesh.
void fit_source_skeleton(const Character& source, const TransferTargetOptions& options, Character* character) {
  SkeletonOptions predict;
  predict.model = options.rig_model();
  predict.up_axis = options.up_axis;
  const PredictedSkeleton predicted = predict_skeleton(*character, predict);
  FitOptions fit;
  fit.up_axis = options.up_axis;
  FittedSkeleton fitted;
  try {
    fitted = fit_into_mesh(source.joints, label_skeleton(predicted), fit, *character);
  } catch (const Error& error) {
    throw Error(character->name + ": has no skeleton, and that of " + source.name + " does not fit: " + error.what() +
                "; give one with --skeleton");
  }
  character->joints = fitted.joints;
  if ((predicted.usable && *predicted.usable < kDoubtfulUsable) || 2 * fitted.matched < fitted.matchable)
    character->notes.push_back("warning: the skeleton of " + source.name +
                               " was fitted to a mesh unlike the training data, so its joints may be wrong; check "
                               "them, or give a skeleton with --skeleton");
}

}  // namespace

TransferTarget transfer_target(const Character& source, Character mesh, const TransferTargetOptions& options) {
  TransferTarget target;
  target.character = std::move(mesh);
  Character& character = target.character;
  if (options.garment) {
    character.joints = source.joints;
    character.influences.clear();
    target.skeleton = source.name;
    target.mapped_by = "the same skeleton";
    for (size_t j = 0; j < source.joints.size(); ++j) target.mapping.push_back(static_cast<int32_t>(j));
    return target;
  }
  target.skeleton = options.skeleton;
  if (character.joints.empty()) {
    fit_source_skeleton(source, options, &character);
    target.skeleton = source.name;
    target.fitted = true;
  }
  target.mapping = find_joint_map(source, options.map, options.path, character, &target.mapped_by);
  return target;
}

}  // namespace sinew
