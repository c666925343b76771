// SPDX-License-Identifier: MIT
// Characters to the engine's deformer and back.
#include "sinew_character/pose/deform.hpp"

#include <algorithm>
#include <optional>

#include "pose/skin_arrays.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/bind/seams.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// Parts that have grown together move apart: open where they meet. Vertices that this doubles come last. nullopt: there are none.
std::optional<Character> opened(const Character& character) {
  if (character.joints.empty()) return std::nullopt;
  const Seams seams = find_seams(character, character.influences);
  if (seams.seams.empty()) return std::nullopt;
  Character out = character;
  out.gltf.reset();  // poses do not need it
  cut_seams(seams, &out);
  return out;
}

}  // namespace

CharacterDeformer::CharacterDeformer(const Character& character, const sinew_deform_options& options)
    : name_(character.name) {
  SkinArrays arrays = skin_arrays(character);
  const std::optional<Character> open = opened(character);
  if (open) arrays = skin_arrays(*open);
  const EngineViews views(open ? *open : character, {});
  const sinew_skin skin = {arrays.joints.data(), arrays.weights.data(), arrays.influences, SINEW_WEIGHT_UNORM16};
  const sinew_status status = deformer_.create(views.mesh, views.skeleton, skin, options);
  if (status != SINEW_OK) throw Error(name_ + ": cannot be deformed: " + sinew_status_text(status));
  all_positions_.resize(arrays.positions.size());
  positions_.resize(3 * character.vertices.size());
}

const std::vector<float>& CharacterDeformer::pose(const std::vector<Affine>& palette) {
  if (palette.size() != deformer_.get().joint_count) {
    throw Error(name_ + ": a pose needs one matrix per joint, expected " + std::to_string(deformer_.get().joint_count) +
                ", found " + std::to_string(palette.size()));
  }
  matrices_.clear();
  for (const Affine& m : palette)
    for (const double x : m) matrices_.push_back(static_cast<float>(x));
  sinew_deform_outputs outputs = SINEW_INIT(sinew_deform_outputs);
  outputs.positions = all_positions_.data();
  const sinew_status status = deformer_.pose(matrices_.data(), &outputs);
  if (status == SINEW_ERROR_NOT_FINITE)
    throw Error(name_ + ": a matrix of the pose is not finite; look at where it comes from");
  if (status != SINEW_OK) throw Error(name_ + ": posing failed: " + sinew_status_text(status));
  corrected_ = outputs.corrected != 0;
  std::copy_n(all_positions_.begin(), positions_.size(), positions_.begin());
  return positions_;
}

Character CharacterDeformer::pose_character(const Character& character, const std::vector<Affine>& palette) {
  return posed_character(character, palette, pose(palette));
}

}  // namespace sinew
