// SPDX-License-Identifier: MIT
// Is a confidence honest, as a picture: of all vertices with confidence 0.8, four in five should be right.
#ifndef SINEW_TRAINER_RELIABILITY_PLOT_HPP
#define SINEW_TRAINER_RELIABILITY_PLOT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "sinew_trainer/confidence.hpp"

namespace sinew {

// The plainest confidence, for binders that tell none: the largest weight of each row as a share of the row, 0..255;
// 0 for an empty row.
std::vector<uint8_t> top_weights(const std::vector<std::vector<Influence>>& rows);

// Hits over confidence and, below it, how much of the data each bin holds, as SVG of sinew_formats/plots.hpp.
std::string reliability_plot(const Reliability& reliability);

}  // namespace sinew
#endif
