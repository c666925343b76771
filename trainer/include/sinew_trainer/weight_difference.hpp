// SPDX-License-Identifier: MIT
// What integers change in the result that is used: weights as a file stores them in eight bits.
#ifndef SINEW_TRAINER_WEIGHT_DIFFERENCE_HPP
#define SINEW_TRAINER_WEIGHT_DIFFERENCE_HPP

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Counts over (vertex, joint) pairs that have weight in at least one of two results, each row rounded to whole 255ths
// that sum to 255.
struct WeightDifference {
  static constexpr size_t kSteps = 8;
  std::array<size_t, kSteps> steps = {};  // pairs that differ by 0, 1, 2, 3, 4..7, 8..15, 16..31, 32 and more 255ths
  size_t vertices = 0, flips = 0;         // flips: the strongest joint differs
  void add(const std::vector<std::vector<Influence>>& a, const std::vector<std::vector<Influence>>& b);
  size_t weights() const;      // pairs
  double close_share() const;  // share of pairs that differ by at most 1/255; 1 for none
  double flip_share() const;   // of the vertices
  static const char* step_name(size_t step);
};

// A row as whole 255ths with the exact sum, largest remainders rounded up; empty for an empty row.
std::map<uint32_t, int> row_unorm8(const std::vector<Influence>& row);
// Joint with the largest weight, the lowest index among equals; UINT32_MAX for an empty row.
uint32_t strongest_joint(const std::vector<Influence>& row);

}  // namespace sinew
#endif
