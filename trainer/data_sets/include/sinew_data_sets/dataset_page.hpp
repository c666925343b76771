// SPDX-License-Identifier: MIT
// A data set at a glance: numbers per family, their spread, and every character with its picture and warnings.
#ifndef SINEW_DATA_SETS_DATASET_PAGE_HPP
#define SINEW_DATA_SETS_DATASET_PAGE_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_data_sets/dataset.hpp"

namespace sinew {

// Counts of one character.
struct CharacterStats {
  std::string name, family;
  CheckReport report;
  size_t bound_joints = 0;                    // joints with weight
  std::array<size_t, 13> vertices_with = {};  // vertices with 0..11 influences, 12 or more
  std::vector<double> recall;                 // share of weight on K candidates, parallel to the Ks; may be empty
  std::vector<uint8_t> png;                   // empty: no picture
  double influences_per_vertex() const;       // mean over bound vertices
};
// Everything but name's recall and picture.
CharacterStats character_stats(const Character& character);

struct DatasetStats {
  std::string folder;
  std::vector<uint32_t> candidate_counts;  // the Ks of `recall`; empty when it was not measured
  std::vector<CharacterStats> characters;
  std::vector<std::pair<std::string, std::string>> unreadable;  // file, one line
};

// One row per family and one for all: smallest / median / largest of each size, means of shares. Plain text.
std::string dataset_table(const DatasetStats& stats);
std::string dataset_json(const DatasetStats& stats);
// One page that needs nothing else. Throws Error when there is no character.
std::string dataset_html(const DatasetStats& stats);

}  // namespace sinew
#endif
