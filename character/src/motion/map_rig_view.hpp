// SPDX-License-Identifier: MIT
// A rig as maps read it: with names, ends and up as the options say.
#ifndef SINEW_CHARACTER_MAP_MAP_RIG_VIEW_HPP
#define SINEW_CHARACTER_MAP_MAP_RIG_VIEW_HPP

#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/motion/map_skeleton.hpp"

namespace sinew {

// Holds pointers into the rig.
struct MapRigView : SkeletonView {
  MapRigView(const MapRig& rig, MaybeAxis up, const MapSkeletonOptions& options) : SkeletonView(rig.joints) {
    if (!options.names) skeleton.names = nullptr;
    if (options.ends && !rig.ends.empty()) skeleton.ends = rig.ends.data();
    skeleton.up = engine_up(up);
  }
};

}  // namespace sinew
#endif
