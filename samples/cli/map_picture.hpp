// SPDX-License-Identifier: MIT
// A picture of a map: both skeletons side by side, what stands for each other in one colour.
#ifndef SINEW_CLI_MAP_PICTURE_HPP
#define SINEW_CLI_MAP_PICTURE_HPP

#include "sinew_character/draw/image.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/axis.hpp"

namespace sinew::cli {

// The target on the left. Joints without a counterpart are grey. `up` is x, y or z; anything else counts as y.
Image draw_map(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
               const MappedSkeleton& map);

}  // namespace sinew::cli
#endif
