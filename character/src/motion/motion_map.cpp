// SPDX-License-Identifier: MIT
// Maps from files and by anatomy, how much of two bodies they reach, and those for weights.
#include "sinew_character/motion/motion_map.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "sinew/published.h"
#include "sinew/rig.h"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/point.hpp"
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

// Parts of bodies by the classes of their joints: which have a counterpart, and how the trunk lies.

namespace {

enum Part : uint8_t { kLegs, kArms, kTrunk, kHead, kParts };

Part part_of(uint8_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_THIGH:
    case SINEW_CLASS_CALF:
    case SINEW_CLASS_FOOT:
      return kLegs;
    case SINEW_CLASS_UPPER_ARM:
    case SINEW_CLASS_FOREARM:
    case SINEW_CLASS_HAND:
      return kArms;
    case SINEW_CLASS_PELVIS:
    case SINEW_CLASS_SPINE:
      return kTrunk;
    case SINEW_CLASS_NECK:
    case SINEW_CLASS_HEAD:
      return kHead;
    default:
      return kParts;
  }
}

// A skeleton's parts, and how much of them a map uses.
class BodyParts {
 public:
  BodyParts(const MapRig& rig, MaybeAxis up, const std::vector<char>& used)
      : rig_(rig), classes_(limb_classes(rig, up)) {
    for (size_t j = 0; j < classes_.size(); ++j) {
      const Part part = part_of(classes_[j]);
      if (part == kParts) continue;
      ++counts_[part];
      mapped_[part] += used[j] != 0 ? 1 : 0;
    }
    measure_lean(up);
  }
  bool has(Part part) const { return counts_[part] > 0; }
  double share(Part part) const { return has(part) ? static_cast<double>(mapped_[part]) / counts_[part] : 0; }
  // Sine of the trunk's direction over the horizon, from the legs on.
  const std::optional<double>& lean() const { return lean_; }

 private:
  Point3 position(size_t j) const {
    const Vec3& p = rig_.joints[j].position;
    return {double{p.x}, double{p.y}, double{p.z}};
  }
  // Where joints of a class begin, in the mean.
  std::optional<Point3> middle_of(uint8_t joint_class) const {
    Point3 sum{};
    double count = 0;
    for (size_t j = 0; j < classes_.size(); ++j) {
      const int parent = rig_.joints[j].parent;
      if (classes_[j] != joint_class || (parent >= 0 && classes_[static_cast<size_t>(parent)] == joint_class)) continue;
      sum = sum + position(j);
      count += 1;
    }
    if (!(count > 0)) return std::nullopt;
    return (1 / count) * sum;
  }
  Point3 leg_ends() const {
    std::vector<char> ends(classes_.size(), 0);
    for (size_t j = 0; j < classes_.size(); ++j) ends[j] = part_of(classes_[j]) == kLegs ? 1 : 0;
    for (size_t j = 0; j < classes_.size(); ++j)
      if (part_of(classes_[j]) == kLegs && rig_.joints[j].parent >= 0)
        ends[static_cast<size_t>(rig_.joints[j].parent)] = 0;
    Point3 sum{};
    double count = 0;
    for (size_t j = 0; j < classes_.size(); ++j) {
      if (ends[j] == 0) continue;
      sum = sum + position(j);
      count += 1;
    }
    return (1 / std::max(1.0, count)) * sum;
  }
  void measure_lean(MaybeAxis up) {
    const std::optional<Point3> legs = middle_of(SINEW_CLASS_THIGH);
    std::optional<Point3> top = middle_of(SINEW_CLASS_UPPER_ARM);
    if (!top) top = middle_of(SINEW_CLASS_HEAD);
    if (!top) top = middle_of(SINEW_CLASS_NECK);
    if (!legs || !top) return;
    size_t axis = axis_index(up.value_or(Axis::kY));
    if (!up) {
      const Point3 down = leg_ends() - *legs;
      for (size_t i = 0; i < 3; ++i) axis = std::abs(down[i]) > std::abs(down[axis]) ? i : axis;
    }
    lean_ = unit(*top - *legs)[axis];
  }

  const MapRig& rig_;
  const std::vector<uint8_t> classes_;
  std::array<int, kParts> counts_ = {}, mapped_ = {};
  std::optional<double> lean_;
};

}  // namespace

MapCover map_cover(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
                   const std::vector<int>& sources) {
  std::vector<char> moved(target.joints.size(), 0), used(source.joints.size(), 0);
  for (size_t t = 0; t < sources.size(); ++t) {
    if (sources[t] < 0) continue;
    moved[t] = 1;
    used[static_cast<size_t>(sources[t])] = 1;
  }
  const BodyParts to(target, target_up, moved), from(source, source_up, used);
  // A part is reached where most of it is in either skeleton: one may have more joints.
  const auto reached = [&](Part part) {
    if (!to.has(part) && !from.has(part)) return 1.0;
    return to.has(part) && from.has(part) ? std::max(to.share(part), from.share(part)) : 0.0;
  };
  MapCover cover;
  const auto least = [&](double share, const char* missing) {
    if (static_cast<float>(share) >= cover.share) return;
    cover.share = static_cast<float>(share);
    cover.missing = missing;
  };
  if (!to.has(kLegs) && !from.has(kLegs)) return cover;  // fish, snakes
  least(reached(kLegs), "no legs");
  least(std::max(reached(kArms), reached(kHead)), "no arms and no head");
  least(reached(kTrunk) > 0 ? 1 : 0, "no trunk");
  if (to.lean() && from.lean()) {
    const double a = *to.lean(), b = *from.lean();
    const double cosine = a * b + std::sqrt(std::max(0.0, 1 - a * a)) * std::sqrt(std::max(0.0, 1 - b * b));
    least(std::max(0.0, cosine), "one goes upright, the other does not");
  }
  return cover;
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
    throw Error(path + ": none of its " + std::to_string(target.joints.size()) + " joints stands for a joint of " +
                source.name + " (" + target.joints.front().name + ", " + source.joints.front().name +
                "); say with --map FILE which joint is which");
  return mapping;
}

}  // namespace sinew
