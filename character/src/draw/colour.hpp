// SPDX-License-Identifier: MIT
// Colours of pictures: sRGB bytes to linear light and back, joints' colours, a scale for errors.
#ifndef SINEW_CHARACTER_PICTURE_COLOUR_HPP
#define SINEW_CHARACTER_PICTURE_COLOUR_HPP

#include <array>
#include <cstdint>

namespace sinew {

using Linear = std::array<float, 3>;  // linear light, 0..1

Linear to_linear(const std::array<uint8_t, 3>& srgb);
std::array<uint8_t, 3> to_srgb(const Linear& light);

}  // namespace sinew
#endif
