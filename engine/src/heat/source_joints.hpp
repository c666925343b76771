// SPDX-License-Identifier: MIT
// Which joints' bones may be heat sources (stage 4).
#ifndef SINEW_HEAT_SOURCE_JOINTS_HPP
#define SINEW_HEAT_SOURCE_JOINTS_HPP

#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"

namespace sinew {

// Fills source_joints [J]: 1 where the joint's bone may be a source. Every usable joint's may, but for a root on the
// floor: a joint without a parent and with 1 to 4 children, in the lowest 3 % of the mesh's height, unless the caller
// said which joints deform or the skeleton has two joints at most. If that would leave no source, every usable joint's bone may be one.
// The mesh is the caller's, not a reduced one, whose height is another.
void choose_source_joints(const Mesh& mesh, const Skeleton& skeleton, uint8_t* source_joints);

}  // namespace sinew
#endif
