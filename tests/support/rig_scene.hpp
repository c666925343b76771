// SPDX-License-Identifier: MIT
// A mesh through sinew_rig() with the bundled model, in a block of exactly the size that was asked for.
#ifndef SINEW_TESTS_SUPPORT_RIG_SCENE_HPP
#define SINEW_TESTS_SUPPORT_RIG_SCENE_HPP

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "mesh_scene.hpp"
#include "open_bundled_model.hpp"
#include "sinew/sinew.hpp"

namespace sinew_test {

struct RiggedScene {
  sinew_status status = SINEW_OK;
  uint32_t count = 0;
  std::vector<float> positions = std::vector<float>(3 * SINEW_MAX_RIG_JOINTS);
  std::vector<int32_t> parents = std::vector<int32_t>(SINEW_MAX_RIG_JOINTS, 77), partners = parents;
  std::vector<uint8_t> flags = std::vector<uint8_t>(SINEW_MAX_RIG_JOINTS, 77), classes = flags;
  std::vector<uint16_t> confidence = std::vector<uint16_t>(SINEW_MAX_RIG_JOINTS, 77), parent_confidence = confidence;
  std::vector<std::string> names;
  sinew_rig_outputs outputs = {};

  RiggedScene(const MeshScene& scene, const sinew_rig_options& options, const sinew_model* model = bundled_rig_model(),
              size_t missing_bytes = 0) {
    const sinew_mesh mesh = scene.mesh_view();
    size_t bytes = 0;
    status = sinew_rig_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count, &options, &bytes);
    if (status != SINEW_OK) return;
    const sinew::Workspace block(bytes);
    std::memset(block.data(), 0x5A, bytes);
    std::vector<char> text(size_t{SINEW_MAX_RIG_JOINTS} * SINEW_JOINT_NAME_BYTES);
    outputs = sinew_rig_outputs_init(positions.data(), parents.data());
    outputs.flags = flags.data();
    outputs.joint_classes = classes.data();
    outputs.partners = partners.data();
    outputs.confidence = confidence.data();
    outputs.parent_confidence = parent_confidence.data();
    outputs.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(text.data());
    status = sinew_rig(model, &mesh, &options, block.data(), bytes - missing_bytes, &outputs);
    count = outputs.joint_count;
    for (uint32_t j = 0; j < count; ++j) names.push_back(text.data() + size_t{j} * SINEW_JOINT_NAME_BYTES);
  }

  bool same_as(const RiggedScene& other) const {
    return status == other.status && count == other.count && positions == other.positions && parents == other.parents &&
           partners == other.partners && flags == other.flags && classes == other.classes &&
           confidence == other.confidence && parent_confidence == other.parent_confidence && names == other.names &&
           outputs.plane == other.outputs.plane && outputs.spread == other.outputs.spread;
  }

  // What every skeleton is, whatever the mesh.
  void expect_sound() const {
    ASSERT_EQ(status, SINEW_OK);
    ASSERT_GE(count, 1u);
    ASSERT_LE(count, SINEW_MAX_RIG_JOINTS);
    EXPECT_EQ(parents[0], -1);
    for (uint32_t j = 0; j < count; ++j) {
      if (j > 0) {
        EXPECT_GE(parents[j], 0);
        EXPECT_LT(parents[j], static_cast<int32_t>(j));
      }
      for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(std::isfinite(positions[3 * j + static_cast<uint32_t>(axis)]));
      EXPECT_LE(classes[j], SINEW_CLASS_OTHER);
      EXPECT_LE(confidence[j], 32768);
      EXPECT_LE(parent_confidence[j], 32768);
      EXPECT_FALSE(names[j].empty());
      for (uint32_t i = 0; i < j; ++i) EXPECT_NE(names[i], names[j]);
      if (partners[j] >= 0) {
        ASSERT_LT(static_cast<uint32_t>(partners[j]), count);
        EXPECT_EQ(partners[static_cast<size_t>(partners[j])], static_cast<int32_t>(j));
      }
    }
    EXPECT_EQ(outputs.used_bytes > 0, true);
  }
};

}  // namespace sinew_test

#endif
