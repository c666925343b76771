// SPDX-License-Identifier: MIT
// How far skeletons and weights move when the same character stands in other poses.
#ifndef SINEW_TRAINER_STABILITY_HPP
#define SINEW_TRAINER_STABILITY_HPP

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Of one character, means over its poses.
struct StabilityFigures {
  double spread =
      0;  // J2J between the joints found in a pose, carried back to rest, and those found at rest; longest sides
  double worst_spread = 0;  // of one pose
  // Shares of the vertices whose strongest joint in a pose is not the one at rest:
  double flips = 0;      // both found anew; joints of two skeletons are the same where pair_joints() pairs them
  double own_flips = 0;  // weights of the character's own skeleton, which moves along
};

// What a skeleton for a mesh and weights for both look like. Joints with deforms = false are bone ends.
struct FoundRig {
  std::vector<Joint> joints;
  std::vector<std::vector<Influence>> influences;  // [V]
};
using FindRig = std::function<FoundRig(const Character&)>;  // of a mesh alone
using BindOwn = std::function<std::vector<std::vector<Influence>>(const Character&)>;

// The test of SPRig (pose-stable rigs): the mesh stands in `poses` random poses by its own weights, those that the training of
// skeletons draws, without their stretches; the same for the same character. A found joint goes back to rest with the bone of the
// target skeleton that is nearest to it. The callbacks get the mesh's triangles alone, and `own` its joints, too.
// Throws Error where there are no faces or no target skeleton, and what the callbacks throw.
StabilityFigures measure_stability(const Character& character, unsigned poses, const FindRig& find, const BindOwn& own);

// By name, in any order: mean and median of characters and families, as Markdown and JSON.
using StabilityRows = std::vector<std::pair<std::string, StabilityFigures>>;
std::string stability_markdown(const StabilityRows& rows);
std::string stability_json(const StabilityRows& rows);

}  // namespace sinew
#endif
