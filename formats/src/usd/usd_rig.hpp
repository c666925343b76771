// SPDX-License-Identifier: MIT
// Skeletons and SkelAnimations of a stage as nodes, skins and animations of its document.
#ifndef SINEW_FORMATS_USD_USD_RIG_HPP
#define SINEW_FORMATS_USD_USD_RIG_HPP

#include <string>
#include <vector>

#include "usd/usd_stage.hpp"

namespace sinew {

struct UsdRig {
  size_t place = 0;
  std::vector<std::string> joints;  // paths as the skeleton has them
  std::vector<int> parents;         // [J] -1 none
  std::vector<Affine> binds;        // [J] in the skeleton's space
  std::vector<Affine> rests;        // [J] below the parent
  std::vector<size_t> nodes;        // [J] of the document

  int joint_of(const std::string& path) const;  // -1 none
};

// A mesh node with its blend shapes, which animations know by their tokens.
struct UsdShapes {
  size_t node = 0;
  std::vector<std::string> tokens;
};

// Adds the joints of every Skeleton. Throws Error for arrays of other lengths than its joints.
std::vector<UsdRig> add_usd_rigs(UsdStage* stage);
// The skin of a mesh: all joints of a rig. `frame`: geomBindTransform.
size_t add_usd_skin(const UsdRig& rig, const Affine& frame, UsdStage* stage);
// Adds every SkelAnimation, for the skeleton that is bound to it, else for the first that has its joints.
void add_usd_animations(const std::vector<UsdRig>& rigs, const std::vector<UsdShapes>& shapes, UsdStage* stage);

}  // namespace sinew
#endif
