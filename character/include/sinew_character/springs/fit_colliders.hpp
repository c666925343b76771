// SPDX-License-Identifier: MIT
// Spheres and capsules that stand for a body, fitted to the skin that its joints move.
#ifndef SINEW_CHARACTER_FIT_COLLIDERS_HPP
#define SINEW_CHARACTER_FIT_COLLIDERS_HPP

#include <vector>

#include "sinew_character/springs/find_springs.hpp"

namespace sinew {

constexpr size_t kMostColliders = 16;

struct BodyColliders {
  std::vector<SpringCollider> colliders;  // named after their parts: "head", "left thigh"
  std::vector<double> errors;  // [colliders] mean distance of the skin from the shape, as a share of its radius
};

// One shape for head, neck, chest, belly, hips and each half of arms and legs, and for hands; kMostColliders at most. Joints of `chains` and
// what hangs on them belong to no part.
BodyColliders fit_colliders(const Character& character, const std::vector<FoundChain>& chains);

// Gives every chain that is kept and has no colliders of its own those within its reach, as one group each; what no chain reaches is
// left out. A chain that starts inside of a shape gets a smaller hit radius, else the shape becomes smaller by a quarter at most, else
// the chain does not get it: at rest nothing is pushed.
void assign_colliders(const Character& character, const BodyColliders& body, std::vector<FoundChain>* chains,
                      Springs* springs, std::vector<double>* errors);

}  // namespace sinew
#endif
