// SPDX-License-Identifier: MIT
// Maps from files and by anatomy; classes by names, else by anatomy.
#include "sinew_character/motion/motion_map.hpp"

#include <algorithm>

#include "sinew/published.h"
#include "sinew_formats/error.hpp"

namespace sinew {

MotionMap map_motion(const MapRig& target, const MapRig& source, MaybeAxis target_up, MaybeAxis source_up,
                     const std::string& map_file, const std::vector<sinew_map_pin>& pins) {
  MotionMap map;
  if (!map_file.empty()) {
    map.sources.assign(target.joints.size(), -1);
    for (const sinew_map_pin& pin : read_map_file(map_file, target, source, MapRepeats::kSources))
      map.sources[pin.target] = pin.source;
    map.reasons.assign(target.joints.size(), SINEW_MAP_PINNED);
    map.how = map_file;
  } else {
    MapSkeletonOptions options;
    options.target_up = target_up;
    options.source_up = source_up;
    options.pins = pins;
    const MappedSkeleton found = map_skeleton(target, source, options);
    map.sources.assign(found.sources.begin(), found.sources.end());
    map.reasons = found.reasons;
    map.how = found.method == SINEW_MAP_BRANCHES ? "branches" : "anatomy and names";
    map.certainty = found.certainty;
    map.cover = map_cover(target, options.target_up, source, options.source_up, map.sources);
  }
  if (std::all_of(map.sources.begin(), map.sources.end(), [](int s) { return s < 0; }))
    throw Error(target.name + ": no joint moves as one of " + source.name + " by " + map.how +
                (map_file.empty() ? "; give --map FILE with lines TARGET_JOINT SOURCE_JOINT" : ""));
  return map;
}

std::vector<uint8_t> motion_classes(const MapRig& target, const MapRig& source, MaybeAxis target_up,
                                    const std::vector<int>& sources) {
  return limb_classes(target, target_up, &source, sources);
}

}  // namespace sinew
