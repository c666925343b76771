// SPDX-License-Identifier: MIT
// Classes, bone ends and mirror images of a skeleton by its names and positions.
#include <algorithm>
#include <string>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

LabeledSkeleton label_skeleton(const std::vector<Joint>& joints) {
  JointVerdicts verdicts = joint_verdicts(joints);
  LabeledSkeleton labeled;
  labeled.joints = joints;
  for (size_t j = 0; j < joints.size(); ++j) {
    const bool end = verdicts.is_end(j);
    const size_t owner = end ? static_cast<size_t>(joints[j].parent) : j;
    const bool part = verdicts.is_part(owner);
    labeled.classes.push_back(part ? verdicts.classes[j] : kClassDetail);
    labeled.ends.push_back(end && part ? 1 : 0);
  }
  return labeled;
}

LabeledSkeleton label_skeleton(const PredictedSkeleton& skeleton) {
  return {skeleton.joints, skeleton.classes, skeleton.ends};
}

PredictedSkeleton skeleton_from_joints(const std::vector<Joint>& joints) {
  if (joints.empty()) throw Error("the skeleton has no joints");
  std::vector<size_t> order = JointTree(joints).parents_first;
  std::vector<int> index(joints.size(), -1);
  bool in_order = true;
  for (size_t j = 0; j < joints.size(); ++j) in_order = in_order && joints[j].parent < static_cast<int>(j);
  if (in_order) std::sort(order.begin(), order.end());
  if (order.size() != joints.size()) throw Error("the joints form a cycle, expected a tree");
  for (size_t i = 0; i < order.size(); ++i) index[order[i]] = static_cast<int>(i);
  PredictedSkeleton skeleton;
  for (const size_t j : order) {
    skeleton.joints.push_back(joints[j]);
    int& parent = skeleton.joints.back().parent;
    if (parent >= 0) parent = index[static_cast<size_t>(parent)];
  }
  LabeledSkeleton labeled = label_skeleton(skeleton.joints);
  skeleton.classes = std::move(labeled.classes);
  skeleton.ends = std::move(labeled.ends);
  for (uint8_t& one : skeleton.classes)
    if (one == kClassDetail) one = SINEW_CLASS_OTHER;
  for (size_t j = 0; j < joints.size(); ++j) skeleton.joints[j].deforms = skeleton.ends[j] == 0;
  JointVerdicts verdicts = joint_verdicts(skeleton.joints);
  skeleton.mirrored = verdicts.mirrored && verdicts.mirror_axis != 1;
  skeleton.facing = verdicts.mirror_axis == 2 ? 1 : 0;
  if (skeleton.facing == 1) skeleton.front = {1, 0, 0};
  skeleton.plane = verdicts.mirror_planes[verdicts.mirror_axis];
  skeleton.partners = std::move(verdicts.images);
  if (!skeleton.mirrored) skeleton.partners.assign(joints.size(), -1);
  skeleton.confidence.assign(joints.size(), 1);
  skeleton.parent_confidence.assign(joints.size(), 1);
  return skeleton;
}

}  // namespace sinew
