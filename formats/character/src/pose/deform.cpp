// SPDX-License-Identifier: MIT
// Characters to the engine's deformer and back.
#include "sinew_character/deform.hpp"

#include "pose/skin_arrays.hpp"
#include "sinew_character/engine_views.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

CharacterDeformer::CharacterDeformer(const Character& character, const sinew_deform_options& options)
    : name_(character.name) {
  const SkinArrays arrays = skin_arrays(character);
  const EngineViews views(character, {});
  const sinew_skin skin = {arrays.joints.data(), arrays.weights.data(), arrays.influences, SINEW_WEIGHT_UNORM16};
  const sinew_status status = deformer_.create(views.mesh, views.skeleton, skin, options);
  if (status != SINEW_OK) throw Error(name_ + ": cannot be deformed: " + sinew_status_text(status));
  positions_.resize(arrays.positions.size());
}

const std::vector<float>& CharacterDeformer::pose(const std::vector<Affine>& palette) {
  if (palette.size() != deformer_.get().joint_count) {
    throw Error(name_ + ": a pose needs one matrix per joint, expected " + std::to_string(deformer_.get().joint_count) +
                ", found " + std::to_string(palette.size()));
  }
  matrices_.clear();
  for (const Affine& m : palette)
    for (const double x : m) matrices_.push_back(static_cast<float>(x));
  sinew_deform_outputs outputs = sinew_deform_outputs_init(positions_.data());
  const sinew_status status = deformer_.pose(matrices_.data(), &outputs);
  if (status == SINEW_ERROR_NOT_FINITE)
    throw Error(name_ + ": a matrix of the pose is not finite; look at where it comes from");
  if (status != SINEW_OK) throw Error(name_ + ": posing failed: " + sinew_status_text(status));
  corrected_ = outputs.corrected != 0;
  return positions_;
}

Character CharacterDeformer::pose_character(const Character& character, const std::vector<Affine>& palette) {
  return posed_character(character, palette, pose(palette));
}

}  // namespace sinew
