// SPDX-License-Identifier: MIT
// The engine's three ways; the corrected one keeps a deformer for as long as weights stay.
#include "skinning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sinew/sinew.h"
#include "sinew_formats/error.hpp"

namespace sinew::web {
namespace {

// Degrees by which `joint` is turned against its parent.
double turn_of(const Character& character, const std::vector<Affine>& palette, size_t joint) {
  const int parent = character.joints[joint].parent;
  const Affine& own = palette[joint];
  double trace = 0;  // of the parent's rotation back, then its own
  for (size_t row = 0; row < 3; ++row)
    for (size_t column = 0; column < 3; ++column) {
      const double above =
          parent < 0 ? static_cast<double>(row == column) : palette[static_cast<size_t>(parent)][4 * row + column];
      trace += above * own[4 * row + column];
    }
  return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

void Skinning::forget() {
  deformer_.reset();
  volumes_.reset();
}

void Skinning::pose(const SkinnedMesh& mesh, const std::vector<Affine>& palette, SkinMethod method,
                    std::vector<float>* posed) {
  if (method == SkinMethod::kVolume || method == SkinMethod::kVolumeAndContact) {
    const bool contact = method == SkinMethod::kVolumeAndContact;
    if (!deformer_ || contact != contact_) {
      sinew_deform_options options = SINEW_INIT(sinew_deform_options);
      options.body_contact = contact ? 1 : 0;
      deformer_.emplace(mesh.character, options);
      contact_ = contact;
    }
    *posed = deformer_->pose(palette);
    return;
  }
  std::vector<float> matrices;
  for (const Affine& m : palette)
    for (const double x : m) matrices.push_back(static_cast<float>(x));
  const sinew_skin skin = {mesh.joints.data(), mesh.weights.data(), mesh.slots, SINEW_WEIGHT_UNORM16};
  const auto pose_skin = method == SkinMethod::kDualQuaternion ? sinew_skin_dual_quaternion : sinew_skin_linear;
  const sinew_status status = pose_skin(mesh.rest.data(), static_cast<uint32_t>(mesh.rest.size() / 3), &skin,
                                        matrices.data(), static_cast<uint32_t>(palette.size()), posed->data());
  if (status != SINEW_OK) throw Error(mesh.character.name + ": " + sinew_status_text(status));
}

nlohmann::json Skinning::bends(const Character& character, const std::vector<Affine>& palette, double least_degrees,
                               const std::vector<float>& posed) {
  nlohmann::json list = nlohmann::json::array();
  for (size_t j = 0; j < palette.size(); ++j) {
    if (character.joints[j].parent < 0) continue;  // turns the whole
    const double degrees = turn_of(character, palette, j);
    if (degrees < least_degrees) continue;
    if (!volumes_) volumes_.emplace(character);
    const std::optional<double> kept = volumes_->kept(j, posed);
    if (kept) list.push_back({{"joint", j}, {"degrees", degrees}, {"kept", *kept}});
  }
  return list;
}

}  // namespace sinew::web
