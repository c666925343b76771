// SPDX-License-Identifier: MIT
// The engine's answer to a skeleton and its surface, and the character put together anew.
#include "sinew_character/motion/simplify_skeleton.hpp"

#include <algorithm>
#include <map>

#include "motion/map_rig_view.hpp"
#include "sinew/sinew.hpp"
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
    if (!found) throw Error(c.name + ": no joint is called " + name + ", which is to be kept");
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

}  // namespace sinew
