// SPDX-License-Identifier: MIT
// What is measurably wrong with a rigged mesh, for pipelines that nobody looks at: `sinew rig --gate`.
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
  double usable = 1;        // how likely the votes make a skeleton that can be used; 1 for one that was not predicted
  double front = 1;         // how likely what was found in front is the front; below it left and right are a coin toss
  double weak_parents = 0;  // share of joints whose parent is a guess: less than 2 % sure
  double exploded = 0;      // share of edges torn in the test pose: 4 times as long, and by 2 % of the longest side
};
constexpr double kMostUnweighted = 0.005, kMostWeakParents = 0.25, kMostExploded = 0.003;

// Edges of a bound character that tear where all of its joints but the roots turn by up to 30 degrees about each axis, in
// three poses that are the same for every character; the worst one. 0 without weights or edges.
double exploded_share(const Character& character);

// Share of joints whose parent is a guess, bone ends aside.
double weak_parents(const PredictedSkeleton& skeleton);
constexpr double kMostGuessed = 0.5;  // above it the user is told, gate or not

GateFigures gate_figures(const Character& character, const PredictedSkeleton& skeleton);
// One line for each figure that fails, with its bound: empty, the rig passes.
//   bound  false: the skeleton alone is looked at
std::vector<std::string> gate_failures(const GateFigures& figures, bool bound);

}  // namespace sinew
#endif
