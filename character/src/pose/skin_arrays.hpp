// SPDX-License-Identifier: MIT
// A character's mesh, weights and pose as the arrays that the engine's skinning takes.
#ifndef SINEW_CHARACTER_SKIN_ARRAYS_HPP
#define SINEW_CHARACTER_SKIN_ARRAYS_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The 12 strongest influences of a row as unorm16 with sum 65535; a row without weight has sum 0.
struct SkinArrays {
  std::vector<float> positions;           // [V x 3]
  std::vector<uint16_t> joints, weights;  // [V x influences]
  uint32_t influences = 1;
};

// Throws Error for missing weights or a joint that does not exist.
SkinArrays skin_arrays(const Character& character);
// [J x 12]. Throws Error where there is not one matrix a joint.
std::vector<float> palette_array(const Character& character, const std::vector<Affine>& palette);
// The character with its vertices at `positions` [V x 3] and its joints moved by the palette; what belongs to the rest pose alone,
// corner normals and the glTF source, is dropped.
Character posed_character(const Character& character, const std::vector<Affine>& palette,
                          const std::vector<float>& positions);

}  // namespace sinew
#endif
