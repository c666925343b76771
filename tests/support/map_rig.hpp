// SPDX-License-Identifier: MIT
// Skeletons for tests of mapping, built joint by joint, and sinew_map() on them.
#ifndef SINEW_TEST_MAP_RIG_HPP
#define SINEW_TEST_MAP_RIG_HPP

#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "aligned_bytes.hpp"
#include "sinew/sinew.h"
#include "skeleton_of.hpp"

namespace sinew_test {

struct TestRig {
  std::vector<std::string> names;
  std::vector<float> positions;
  std::vector<int32_t> parents;
  std::vector<uint8_t> ends;

  int32_t add(const std::string& name, int32_t parent, float x, float y, float z, bool end = false) {
    names.push_back(name);
    positions.insert(positions.end(), {x, y, z});
    parents.push_back(parent);
    ends.push_back(end ? 1 : 0);
    return static_cast<int32_t>(names.size()) - 1;
  }
  uint32_t count() const { return static_cast<uint32_t>(names.size()); }
  int32_t find(const std::string& name) const {
    for (size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return static_cast<int32_t>(i);
    }
    return -1;
  }
};

// A body that faces +z with its left at +x: `spines` joints above the hips, arms hanging or in a T, toes.
inline TestRig humanoid(int spines, bool t_pose, const std::string& prefix = "") {
  TestRig rig;
  const auto name = [&](const std::string& word) { return prefix + word; };
  const int32_t hips = rig.add(name("Hips"), -1, 0, 1, 0);
  int32_t last = hips;
  for (int i = 1; i <= spines; ++i) {
    last = rig.add(name("Spine" + std::to_string(i)), last, 0,
                   1 + 0.4f * static_cast<float>(i) / static_cast<float>(spines), 0);
  }
  const int32_t chest = last;
  const int32_t neck = rig.add(name("Neck"), chest, 0, 1.5f, 0);
  const int32_t head = rig.add(name("Head"), neck, 0, 1.6f, 0.02f);
  rig.add(name("HeadEnd"), head, 0, 1.8f, 0.02f, true);
  for (const float s : {1.0f, -1.0f}) {
    const std::string side = s > 0 ? "Left" : "Right";
    const int32_t shoulder = rig.add(name(side + "Shoulder"), chest, 0.05f * s, 1.42f, 0);
    const int32_t arm = rig.add(name(side + "Arm"), shoulder, 0.18f * s, 1.42f, 0);
    const int32_t elbow = t_pose ? rig.add(name(side + "ForeArm"), arm, 0.45f * s, 1.42f, -0.01f)
                                 : rig.add(name(side + "ForeArm"), arm, 0.22f * s, 1.15f, -0.02f);
    const int32_t hand = t_pose ? rig.add(name(side + "Hand"), elbow, 0.7f * s, 1.42f, 0)
                                : rig.add(name(side + "Hand"), elbow, 0.25f * s, 0.9f, 0.03f);
    rig.add(name(side + "HandEnd"), hand, t_pose ? 0.85f * s : 0.25f * s, t_pose ? 1.42f : 0.75f, 0.05f, true);
    const int32_t thigh = rig.add(name(side + "UpLeg"), hips, 0.1f * s, 0.95f, 0);
    const int32_t knee = rig.add(name(side + "Leg"), thigh, 0.1f * s, 0.5f, 0.02f);
    const int32_t foot = rig.add(name(side + "Foot"), knee, 0.1f * s, 0.08f, -0.02f);
    const int32_t toe = rig.add(name(side + "Toe"), foot, 0.1f * s, 0.02f, 0.1f);
    rig.add(name(side + "ToeEnd"), toe, 0.1f * s, 0.02f, 0.18f, true);
  }
  return rig;
}

struct MapCall {
  bool names = false, ends = true, up_known = true;
  uint32_t method = SINEW_MAP_AUTO;
  std::vector<sinew_map_pin> pins;
  uint32_t first = 0, cost = 0;                   // of branches
  std::vector<float> target_areas, source_areas;  // empty: not known
  std::vector<uint8_t> animated;                  // empty: all are
  int fill = 0xCD;                                // what the workspace holds before

  sinew_status status = SINEW_OK;
  std::vector<int32_t> sources;
  std::vector<uint16_t> confidence;
  std::vector<uint8_t> reasons;
  sinew_map_outputs outputs = {};

  sinew_skeleton view(const TestRig& rig, std::vector<const char*>* texts) const {
    sinew_skeleton view = skeleton_of(rig.positions.data(), rig.parents.data(), rig.count());
    for (const std::string& name : rig.names) texts->push_back(name.c_str());
    if (names) view.names = texts->data();
    if (ends) view.ends = rig.ends.data();
    if (up_known) view.up = SINEW_UP_Y;
    return view;
  }
  MapCall& run(const TestRig& target, const TestRig& source) {
    std::vector<const char*> texts[2];
    const sinew_skeleton to = view(target, &texts[0]), from = view(source, &texts[1]);
    sinew_map_options options = SINEW_INIT(sinew_map_options);
    options.method = method;
    options.pins = pins.data();
    options.pin_count = static_cast<uint32_t>(pins.size());
    options.branches_first = first;
    options.branches_cost = cost;
    if (!target_areas.empty()) options.target_areas = target_areas.data();
    if (!source_areas.empty()) options.source_areas = source_areas.data();
    if (!animated.empty()) options.source_animated = animated.data();
    size_t bytes = 0;
    status = sinew_map_workspace_size(to.joint_count, from.joint_count, &bytes);
    if (status != SINEW_OK) return *this;
    sinew::test::AlignedBytes block(bytes);
    std::memset(block.data(), fill, bytes);
    sources.assign(to.joint_count, -7);
    confidence.assign(to.joint_count, 7);
    reasons.assign(to.joint_count, 77);
    outputs = SINEW_INIT(sinew_map_outputs);
    outputs.sources = sources.data();
    outputs.confidence = confidence.data();
    outputs.reasons = reasons.data();
    status = sinew_map(&to, &from, &options, block.data(), bytes, &outputs);
    return *this;
  }
  std::string source_of(const TestRig& target, const TestRig& source, const std::string& name) const {
    const int32_t j = sources[static_cast<size_t>(target.find(name))];
    return j < 0 ? "-" : source.names[static_cast<size_t>(j)];
  }
};

}  // namespace sinew_test
#endif
