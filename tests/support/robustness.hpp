// SPDX-License-Identifier: MIT
// How far weights move when the same character is moved, scaled, turned, mirrored, renumbered or remeshed.
#ifndef SINEW_TESTS_ROBUSTNESS_HPP
#define SINEW_TESTS_ROBUSTNESS_HPP

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

enum class Demand {
  kEqual,     // the input says the same to the last bit, so must the weights
  kRounding,  // the input differs by the rounding of its floats
  kClose,     // another mesh, another position of the grid: at most 0.05 mean L1
};

// One change of one character against the character as it was.
struct RobustnessFigure {
  std::string change;
  Demand demand = Demand::kClose;
  double mean = 0;      // L1 between the two rows of a vertex, mean over the vertices both meshes have
  double largest = 0;   // of one vertex; at most 2
  size_t compared = 0;  // vertices
};

// Rows of a character that has a mesh and joints, nothing else. [V]
using BindRows = std::function<std::vector<std::vector<Influence>>(const Character&)>;

// Binds the character, then every changed one, in the same order for all characters. Its coordinates are first rounded
// to 2^-18 of its size or finer, so that moving and halving round nothing. Throws Error when there are no faces, and
// what `bind` throws.
std::vector<RobustnessFigure> measure_robustness(const Character& character, const BindRows& bind);

}  // namespace sinew
#endif
