// SPDX-License-Identifier: MIT
// The outline of a picture's mesh: the edges between its front and its back.
#ifndef SINEW_CHARACTER_PICTURE_SILHOUETTE_HPP
#define SINEW_CHARACTER_PICTURE_SILHOUETTE_HPP

#include <utility>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

using Run = std::pair<float, float>;  // from x to x

class Silhouette {
 public:
  explicit Silhouette(const Character& mesh) : mesh_(mesh) {}
  // Where a level line is inside, from left to right.
  std::vector<Run> at(float y) const;
  bool has(float x, float y) const;

 private:
  const Character& mesh_;
};

}  // namespace sinew
#endif
