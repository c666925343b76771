// SPDX-License-Identifier: MIT
// Maps of skeletons with fewer joints: as published, the map is made at the high level and then reduced by the low one.
#ifndef SINEW_CHARACTER_MAP_LEVELS_HPP
#define SINEW_CHARACTER_MAP_LEVELS_HPP

#include "sinew_character/motion/map_skeleton.hpp"

namespace sinew {

// As map_skeleton(), between what both skeletons keep at the high level of sinew_simplify(). Joints that go have no source;
// pinned ones stay.
//   low  the map is then reduced by the low level: a joint of the target that goes leaves its source to the joint that it
//        is part of, if that has none, and a source that goes gives way to the joint that it is part of, where no other
//        joint of the target has that one
MappedSkeleton map_at_level(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options, bool low);

}  // namespace sinew
#endif
