// SPDX-License-Identifier: MIT
// The engine's answer to a skeleton and its surface, and the character put together anew.
#include "sinew_character/motion/simplify_skeleton.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "sinew/sinew.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

void merge_weights(const Simplified& simplified, std::vector<Influence>* row) {
  std::map<uint32_t, float> sums;
  for (const Influence& influence : *row)
    sums[static_cast<uint32_t>(simplified.number[simplified.into[influence.joint]])] += influence.weight;
  row->clear();
  for (const auto& [joint, weight] : sums) row->push_back({joint, weight});
  std::stable_sort(row->begin(), row->end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
}

std::vector<uint8_t> kept_joints(const SimplifyOptions& options, const Character& c) {
  std::vector<uint8_t> keep(c.joints.size(), 0);
  for (const std::string& name : options.keep) {
    bool found = false;
    for (size_t j = 0; j < c.joints.size(); ++j) {
      if (c.joints[j].name != name) continue;
      found = true;
      keep[j] = 1;
    }
    if (!found) throw Error(c.name + ": unknown joint " + name + "to keep");
  }
  for (const uint32_t j : options.keep_joints) keep.at(j) = 1;
  return keep;
}

}  // namespace

std::vector<uint32_t> joints_to_merge(const SimplifyOptions& options, const Character& character) {
  const std::vector<Joint>& joints = character.joints;
  if (joints.empty()) throw Error(character.name + ": no joints to simplify");
  const std::vector<uint8_t> keep = kept_joints(options, character);
  const MapRig rig = map_rig_of(character);  // arms and legs are what they are to maps
  const MapRigView view(rig, {}, {});
  const JointSurfaces surfaces = joint_surfaces(character);
  SimplifySettings settings;
  settings.level = options.low ? SINEW_SIMPLIFY_LOW : SINEW_SIMPLIFY_HIGH;
  settings.joint_count = options.joints;
  settings.as_drawn = options.as_drawn ? 1 : 0;
  if (!surfaces.centroids.empty()) settings.centroids = surfaces.centroids.data();
  Workspace workspace;
  std::vector<uint32_t> into;
  const sinew_status status = simplify(view.skeleton, surfaces.shares.empty() ? nullptr : surfaces.shares.data(),
                                       keep.data(), settings, &workspace, &into);
  if (status != SINEW_OK)
    throw Error(character.name + ": the skeleton cannot be simplified: " + sinew_status_text(status));
  return into;
}

std::vector<Joint> joints_left(const std::vector<Joint>& joints, const std::vector<uint32_t>& into,
                               std::vector<int>* number) {
  number->clear();
  std::vector<Joint> left;
  for (size_t j = 0; j < joints.size(); ++j) {
    number->push_back(into[j] == j ? static_cast<int>(left.size()) : -1);
    if (into[j] == j) left.push_back(joints[j]);
  }
  for (Joint& joint : left) {
    if (joint.parent >= 0) joint.parent = (*number)[into[static_cast<size_t>(joint.parent)]];
  }
  return left;
}

Simplified simplify_skeleton(const SimplifyOptions& options, Character* character) {
  Simplified simplified;
  simplified.into = joints_to_merge(options, *character);
  std::vector<Joint> left = joints_left(character->joints, simplified.into, &simplified.number);
  for (std::vector<Influence>& row : character->influences) merge_weights(simplified, &row);
  character->joints = std::move(left);
  return simplified;
}

namespace {

// The part of each joint of a rig at a level.
std::vector<uint32_t> merged(const MapRig& rig, const MapSkeletonOptions& options, const std::vector<uint8_t>& keep,
                             bool low) {
  const MapRigView view(rig, {}, options);
  SimplifySettings settings;
  settings.level = low ? SINEW_SIMPLIFY_LOW : SINEW_SIMPLIFY_HIGH;
  if (!rig.surfaces.centroids.empty()) settings.centroids = rig.surfaces.centroids.data();
  Workspace workspace;
  std::vector<uint32_t> into;
  const float* shares = rig.surfaces.shares.empty() ? nullptr : rig.surfaces.shares.data();
  const sinew_status status = simplify(view.skeleton, shares, keep.data(), settings, &workspace, &into);
  if (status != SINEW_OK) throw Error(rig.name + ": cannot simplify for a map, " + sinew_status_text(status));
  return into;
}

struct Reduced {
  MapRig rig;
  std::vector<int> number;      // [J before] -1 where it is gone
  std::vector<uint32_t> joint;  // [J now] which it was
};

Reduced reduced(const MapRig& rig, const std::vector<uint32_t>& into) {
  Reduced out;
  out.rig.name = rig.name;
  out.rig.joints = joints_left(rig.joints, into, &out.number);
  for (uint32_t j = 0; j < into.size(); ++j) {
    if (into[j] != j) continue;
    out.joint.push_back(j);
    if (!rig.ends.empty()) out.rig.ends.push_back(rig.ends[j]);
  }
  // A joint that stays has the surface and the motion of those that became part of it.
  if (!rig.surfaces.shares.empty()) out.rig.surfaces.shares.assign(out.joint.size(), 0);
  if (!rig.animated.empty()) out.rig.animated.assign(out.joint.size(), 0);
  for (uint32_t j = 0; j < into.size(); ++j) {
    const size_t stays = static_cast<size_t>(out.number[into[j]]);
    if (!rig.surfaces.shares.empty()) out.rig.surfaces.shares[stays] += rig.surfaces.shares[j];
    if (!rig.animated.empty()) out.rig.animated[stays] |= rig.animated[j];
  }
  return out;
}

// The map between fewer joints as one of all.
MappedSkeleton widened(MappedSkeleton map, const Reduced& target, const Reduced& source) {
  const size_t count = target.number.size();
  MappedSkeleton wide = map;
  wide.sources.assign(count, -1);
  wide.confidence.assign(count, 0);
  wide.reasons.assign(count, SINEW_MAP_FEWER_JOINTS);
  for (size_t j = 0; j < target.joint.size(); ++j) {
    const int32_t from = map.sources[j];
    wide.sources[target.joint[j]] = from >= 0 ? static_cast<int32_t>(source.joint[static_cast<size_t>(from)]) : -1;
    wide.confidence[target.joint[j]] = map.confidence[j];
    wide.reasons[target.joint[j]] = map.reasons[j];
  }
  return wide;
}

void drop(MappedSkeleton* map, size_t joint) {
  map->sources[joint] = -1;
  map->confidence[joint] = 0;
  map->reasons[joint] = SINEW_MAP_FEWER_JOINTS;
}

void reduce(const std::vector<uint32_t>& target_into, const std::vector<uint32_t>& source_into, MappedSkeleton* map) {
  std::vector<uint8_t> used(source_into.size(), 0);
  for (size_t t = 0; t < target_into.size(); ++t) {
    if (map->sources[t] < 0) continue;
    if (target_into[t] != t) {
      const uint32_t stays = target_into[t];  // gets the source, if it has none of its own
      if (map->sources[stays] < 0) {
        map->sources[stays] = map->sources[t];
        map->confidence[stays] = map->confidence[t];
        map->reasons[stays] = map->reasons[t];
      }
      drop(map, t);
    }
  }
  for (const int32_t from : map->sources) {
    if (from >= 0 && source_into[static_cast<size_t>(from)] == static_cast<uint32_t>(from))
      used[static_cast<size_t>(from)] = 1;
  }
  for (size_t t = 0; t < target_into.size(); ++t) {
    const int32_t from = map->sources[t];
    if (from < 0 || source_into[static_cast<size_t>(from)] == static_cast<uint32_t>(from)) continue;
    const uint32_t stays = source_into[static_cast<size_t>(from)];
    if (used[stays] != 0) {
      drop(map, t);
      continue;
    }
    map->sources[t] = static_cast<int32_t>(stays);
    used[stays] = 1;
  }
}

}  // namespace

// The map of both simplified skeletons, brought back to the joints that they had.
MappedSkeleton map_at_level(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options, bool low) {
  std::vector<uint8_t> keep[2] = {std::vector<uint8_t>(target.joints.size(), 0),
                                  std::vector<uint8_t>(source.joints.size(), 0)};
  for (const sinew_map_pin& pin : options.pins) {
    keep[0].at(pin.target) = 1;
    if (pin.source >= 0) keep[1].at(static_cast<size_t>(pin.source)) = 1;
  }
  const Reduced to = reduced(target, merged(target, options, keep[0], false)),
                from = reduced(source, merged(source, options, keep[1], false));
  MapSkeletonOptions own = options;
  for (sinew_map_pin& pin : own.pins) {
    pin.target = static_cast<uint32_t>(to.number[pin.target]);
    if (pin.source >= 0) pin.source = from.number[static_cast<size_t>(pin.source)];
  }
  MappedSkeleton map = widened(map_skeleton(to.rig, from.rig, own), to, from);
  if (low) reduce(merged(target, options, keep[0], true), merged(source, options, keep[1], true), &map);
  map.mapped = static_cast<size_t>(
      std::count_if(map.sources.begin(), map.sources.end(), [](int32_t from_joint) { return from_joint >= 0; }));
  return map;
}

}  // namespace sinew
