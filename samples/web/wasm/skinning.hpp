// SPDX-License-Identifier: MIT
// How the page's mesh follows its joints: linear, by dual quaternions, or corrected so that bends keep their volume, and how
// much of it they keep.
#ifndef SINEW_WEB_SKINNING_HPP
#define SINEW_WEB_SKINNING_HPP

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "sinew_character/pose/bend_volume.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew::web {

enum class SkinMethod : uint32_t { kLinear = 0, kDualQuaternion, kVolume, kVolumeAndContact };

// A bound mesh as the engine skins it: borrowed.
struct SkinnedMesh {
  const Character& character;                    // with joints and influences
  const std::vector<float>& rest;                // [V x 3]
  const std::vector<uint16_t>&joints, &weights;  // [V x slots], rows of sum 65535, rows of zeros stay
  uint32_t slots;
};

class Skinning {
 public:
  // Joints or weights have changed: what was made of them is made anew.
  void forget();

  // Throws Error for what the engine refuses; `posed` [V x 3] is as it was then.
  void pose(const SkinnedMesh& mesh, const std::vector<Affine>& palette, SkinMethod method, std::vector<float>* posed);

  // [{joint, degrees, kept}], by joints: bends of joints that the palette turns by at least `least_degrees` against their
  // parents, and how much of their volume at rest they have, 1 = all.
  nlohmann::json bends(const Character& character, const std::vector<Affine>& palette, double least_degrees,
                       const std::vector<float>& posed);

 private:
  std::optional<CharacterDeformer> deformer_;
  bool contact_ = false;  // of the deformer
  std::optional<BendVolumes> volumes_;
};

}  // namespace sinew::web
#endif
