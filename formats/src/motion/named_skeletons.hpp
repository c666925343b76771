// SPDX-License-Identifier: MIT
// Skeletons of motions whose files say numbers and no names: the order of their joints.
#ifndef SINEW_FORMATS_MOTION_NAMED_SKELETONS_HPP
#define SINEW_FORMATS_MOTION_NAMED_SKELETONS_HPP

#include <string>
#include <vector>

namespace sinew {

// Joints of a body model in its order, with the names of person_joints().
struct BodyModel {
  const char* name;
  std::vector<std::string> joints;
};
// SMPL without and with hands' ends, SMPL-H, SMPL-X: no two have as many joints.
const std::vector<BodyModel>& body_models();

// A skeleton with names and parents of its own; parents come first.
struct NamedSkeleton {
  const char* name;
  std::vector<std::string> joints;
  std::vector<int> parents;  // -1 for the root, which is joint 0
};
// SOMA of 77 and of 30 joints, Unitree G1 of 34, SMPL of 22: no two have as many joints.
const std::vector<NamedSkeleton>& named_skeletons();

}  // namespace sinew
#endif
