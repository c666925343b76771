// SPDX-License-Identifier: MIT
// A brush on the weights of a character: what the user shows the next bind.
#ifndef SINEW_WEB_PAINT_HPP
#define SINEW_WEB_PAINT_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew::web {

struct Stroke {
  uint32_t vertex = 0;  // in the middle of the brush
  float radius = 0;     // in the character's units
  int32_t joint = -1;   // gets weight; -1: rows become more like those of their neighbours
  float strength = 1;   // 0..1 in the middle, less towards the rim
};

// Changes the rows of vertices that are within the radius and reached along edges inside of it, so that a brush on one finger
// leaves the next one alone.
//   positions        [V x 3] as the user sees them
//   influence_count  most influences a row keeps
//   rows             in/out [V], none empty
//   painted          in/out [V] 1 for rows that were changed
void paint(const Character& character, const std::vector<float>& positions, const Stroke& stroke,
           uint32_t influence_count, std::vector<std::vector<Influence>>* rows, std::vector<uint8_t>* painted);

}  // namespace sinew::web
#endif
