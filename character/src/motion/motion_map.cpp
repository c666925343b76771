// SPDX-License-Identifier: MIT
// Maps from files and by anatomy, and those for weights.
#include "sinew_character/motion/motion_map.hpp"

#include <algorithm>
#include <optional>

#include "sinew/published.h"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

MotionMap map_motion(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options,
                     const std::string& map_file) {
  MotionMap map;
  if (!map_file.empty()) {
    map.sources.assign(target.joints.size(), -1);
    for (const sinew_map_pin& pin : read_map_file(map_file, target, source, MapRepeats::kSources))
      map.sources[pin.target] = pin.source;
    map.reasons.assign(target.joints.size(), SINEW_MAP_PINNED);
    map.how = map_file;
  } else {
    const MappedSkeleton found = map_skeleton(target, source, options);
    map.sources.assign(found.sources.begin(), found.sources.end());
    map.reasons = found.reasons;
    map.how = found.method == SINEW_MAP_BRANCHES ? "branches" : "anatomy and names";
    map.certainty = found.certainty;
  }
  map.cover = map_cover(target, options.target_up, source, options.source_up, map.sources);
  if (!map_file.empty()) map.cover.share = 1;  // what the user says is not doubted
  if (std::all_of(map.sources.begin(), map.sources.end(), [](int s) { return s < 0; }))
    throw Error(target.name + ": no joint maps to one of " + source.name + " by " + map.how +
                (map_file.empty() ? "; give --map FILE with lines TARGET_JOINT SOURCE_JOINT" : ""));
  return map;
}

std::vector<uint8_t> motion_classes(const MapRig& target, const MapRig& source, MaybeAxis target_up,
                                    const std::vector<int>& sources) {
  return limb_classes(target, target_up, &source, sources);
}

// Maps of joints for weights: a file's, by names, by anatomy.
JointMapping find_joint_map(const Character& source, const std::string& map, const std::string& path,
                            const Character& target, std::string* mapped_by) {
  MapRig target_rig = map_rig_of(target), source_rig = map_rig_of(source);
  target_rig.name = path;
  source_rig.name = source.name;
  if (!map.empty()) {
    *mapped_by = map;
    JointMapping mapping(source.joints.size(), -1);
    for (const sinew_map_pin& pin : read_map_file(map, target_rig, source_rig, MapRepeats::kTargets))
      if (pin.source >= 0) mapping[static_cast<size_t>(pin.source)] = static_cast<int32_t>(pin.target);
    if (mapped_count(mapping) == 0) throw Error(map + ": maps no joint; expected lines TARGET_JOINT SOURCE_JOINT");
    return mapping;
  }
  JointMapping mapping = map_joints_by_name(source.joints, target.joints);
  *mapped_by = "equal names";
  if (2 * mapped_count(mapping) >= std::min(source.joints.size(), target.joints.size())) return mapping;
  MapSkeletonOptions options;
  options.target_up = options.source_up = std::nullopt;
  const MappedSkeleton found = map_skeleton(target_rig, source_rig, options);
  *mapped_by = "anatomy and names";
  mapping.assign(source.joints.size(), -1);
  for (size_t t = 0; t < found.sources.size(); ++t)
    if (found.sources[t] >= 0) mapping[static_cast<size_t>(found.sources[t])] = static_cast<int32_t>(t);
  if (mapped_count(mapping) == 0)
    throw Error(path + ": none of its " + std::to_string(target.joints.size()) + " joints maps to a joint of " +
                source.name + " (" + target.joints.front().name + ", " + source.joints.front().name +
                "); map them with --map FILE");
  return mapping;
}

}  // namespace sinew
