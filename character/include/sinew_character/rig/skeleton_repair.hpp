// SPDX-License-Identifier: MIT
// Repairs skeletons without a hierarchy, in other units or beside the mesh.
#ifndef SINEW_CHARACTER_SKELETON_REPAIR_HPP
#define SINEW_CHARACTER_SKELETON_REPAIR_HPP

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// If most joints have no parent, assigns parents along the minimum spanning tree, in which consecutive joints and
// joints on the same side of the body are closer. Returns the number of new parents. Writers treat the repaired
// joints as those of the file.
size_t infer_parents(std::vector<Joint>* joints);

// The transform that brings a skeleton into its mesh: p -> rotation (scale p) + shift, in the mesh's units.
struct SkeletonFit {
  double scale = 1;
  std::array<double, 9> rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // row-major
  Vec3 shift;
  std::string what;  // "the skeleton is 100 times as large as the mesh", for the user
};
// Returns nullopt if the joints are in the mesh, or if no transform brings most of them there.
std::optional<SkeletonFit> find_skeleton_fit(const Character& character);
void apply_skeleton_fit(const SkeletonFit& fit, std::vector<Joint>* joints);

}  // namespace sinew
#endif
