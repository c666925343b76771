// SPDX-License-Identifier: MIT
// Gate for unattended pipelines: measures faults of a rigged mesh, `sinew rig --gate`.
#ifndef SINEW_CHARACTER_RIG_GATE_HPP
#define SINEW_CHARACTER_RIG_GATE_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Figures of a gate, each with its bound. `sinew rig FOLDER --gate --json` prints them.
struct GateFigures {
  double unweighted = 0;    // share of vertices without weight
  double usable = 1;        // probability that the skeleton is usable; 1 if it was not predicted
  double front = 1;         // probability that the front is correct; below the bound left and right are uncertain
  double weak_parents = 0;  // share of joints whose parent has a confidence below 2 %
  double exploded = 0;  // share of edges torn in the test pose: 4 times as long, and longer by 2 % of the longest side
};
constexpr double kMostUnweighted = 0.005, kMostWeakParents = 0.25, kMostExploded = 0.003;

// Share of edges of a bound character that tear in the worst of three fixed poses, in which all joints but the roots
// rotate by up to 30 degrees about each axis. 0 without weights or edges.
double exploded_share(const Character& character);

// Share of joints with an uncertain parent, not counting bone ends.
double weak_parents(const PredictedSkeleton& skeleton);
constexpr double kMostGuessed = 0.5;  // above this share the result carries a warning, with or without a gate

GateFigures gate_figures(const Character& character, const PredictedSkeleton& skeleton);
// Returns one line per failed figure, with its bound; empty if the rig passes.
//   bound  false: only the skeleton is checked
std::vector<std::string> gate_failures(const GateFigures& figures, bool bound);

}  // namespace sinew
#endif
