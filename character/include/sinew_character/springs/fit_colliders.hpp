// SPDX-License-Identifier: MIT
// Fits spheres and capsules to the skin of a body as colliders.
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

// Fits one shape each to head, neck, chest, belly, hips, hands, and each half of arms and legs; at most
// kMostColliders. Joints of `chains` and their descendants are excluded.
BodyColliders fit_colliders(const Character& character, const std::vector<FoundChain>& chains);

// Gives each kept chain without own colliders those within its reach, as one group; colliders that no chain reaches
// are left out. If a chain starts inside a shape, its hit radius is reduced, else the shape by at most a quarter,
// else the chain does not get it: at rest nothing is pushed.
void assign_colliders(const Character& character, const BodyColliders& body, std::vector<FoundChain>* chains,
                      Springs* springs, std::vector<double>* errors);

}  // namespace sinew
#endif
