// SPDX-License-Identifier: MIT
// A skeleton with room for more joints, as sinew_rig() gives them and sinew_rig_details() lets them grow.
#ifndef SINEW_TESTS_SUPPORT_RIG_SKELETON_HPP
#define SINEW_TESTS_SUPPORT_RIG_SKELETON_HPP

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "sinew/rig.h"

namespace sinew_test {

struct RigSkeleton {
  std::vector<float> positions = std::vector<float>(3 * SINEW_MAX_RIG_JOINTS);
  std::vector<int32_t> parents = std::vector<int32_t>(SINEW_MAX_RIG_JOINTS), partners = parents;
  std::vector<uint8_t> flags = std::vector<uint8_t>(SINEW_MAX_RIG_JOINTS), classes = flags;
  std::vector<uint16_t> confidence = std::vector<uint16_t>(SINEW_MAX_RIG_JOINTS), parent_confidence = confidence;
  std::vector<char> text = std::vector<char>(size_t{SINEW_MAX_RIG_JOINTS} * SINEW_JOINT_NAME_BYTES);
  sinew_rig_outputs outputs = SINEW_INIT(sinew_rig_outputs);

  RigSkeleton() {
    outputs.positions = positions.data();
    outputs.parents = parents.data();
    outputs.flags = flags.data();
    outputs.joint_classes = classes.data();
    outputs.partners = partners.data();
    outputs.confidence = confidence.data();
    outputs.parent_confidence = parent_confidence.data();
    outputs.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(text.data());
  }
  RigSkeleton(const RigSkeleton&) = delete;
  RigSkeleton& operator=(const RigSkeleton&) = delete;

  void add(const std::string& name, float x, float y, float z, int parent, uint8_t joint_class, uint8_t flag,
           int partner) {
    const uint32_t j = outputs.joint_count++;
    positions[3 * j] = x;
    positions[3 * j + 1] = y;
    positions[3 * j + 2] = z;
    parents[j] = parent;
    partners[j] = partner;
    classes[j] = joint_class;
    flags[j] = flag;
    std::strcpy(outputs.names[j], name.c_str());
  }
  std::string name(uint32_t j) const { return &text[size_t{j} * SINEW_JOINT_NAME_BYTES]; }
  bool same_as(const RigSkeleton& o) const {
    return outputs.joint_count == o.outputs.joint_count && positions == o.positions && parents == o.parents &&
           partners == o.partners && flags == o.flags && classes == o.classes && confidence == o.confidence &&
           parent_confidence == o.parent_confidence && text == o.text;
  }
};

}  // namespace sinew_test
#endif
