// SPDX-License-Identifier: MIT
// What is measurably wrong with a rigged mesh, for pipelines that nobody looks at: `sinew rig --gate`.
#ifndef SINEW_CHARACTER_RIG_GATE_HPP
#define SINEW_CHARACTER_RIG_GATE_HPP

#include <string>
#include <vector>

#include "sinew_character/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Figures of a gate, each with the bound above which it fails. `sinew rig FOLDER --gate --json` prints them.
struct GateFigures {
  double unweighted = 0;    // share of vertices without weight
  double spread = 0;        // of the votes, share of the longest side
  double weak_parents = 0;  // share of joints whose parent is a guess: less than 2 % sure
  double exploded = 0;      // share of edges torn in the test pose: 4 times as long, and by 2 % of the longest side
};
constexpr double kMostUnweighted = 0.005, kMostSpread = 0.05, kMostWeakParents = 0.25, kMostExploded = 0.003;

// Edges of a bound character that tear where all of its joints but the roots turn by up to 30 degrees about each axis, in
// three poses that are the same for every character; the worst one. 0 without weights or edges.
double exploded_share(const Character& character);

GateFigures gate_figures(const Character& character, const PredictedSkeleton& skeleton);
// One line for each figure that fails, with its bound: empty, the rig passes.
//   bound  false: the skeleton alone is looked at
std::vector<std::string> gate_failures(const GateFigures& figures, bool bound);

}  // namespace sinew
#endif
