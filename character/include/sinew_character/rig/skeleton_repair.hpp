// SPDX-License-Identifier: MIT
// Skeletons that came without a hierarchy, in other units or beside the mesh.
#ifndef SINEW_CHARACTER_SKELETON_REPAIR_HPP
#define SINEW_CHARACTER_SKELETON_REPAIR_HPP

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Gives joints without a parent one when most have none: along the shortest tree that joins all joints, in which joints
// that are numbered in a row or lie on the same side of the body are closer. Returns how many got one (0: nothing to do).
// Writers take the joints of a file with parents that it did not have as its own.
size_t infer_parents(std::vector<Joint>* joints);

// What would bring a skeleton into its mesh: p -> turn (scale p) + shift, in the mesh's units.
struct SkeletonFit {
  double scale = 1;
  std::array<double, 9> rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // row-major
  Vec3 shift;
  std::string what;  // "the skeleton is 100 times as large as the mesh", for the user
};
// nullopt when the joints lie in the mesh as they should, or when no fit brings most of them there.
std::optional<SkeletonFit> find_skeleton_fit(const Character& character);
void apply_skeleton_fit(const SkeletonFit& fit, std::vector<Joint>* joints);

}  // namespace sinew
#endif
