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
#include "rig_skeleton.hpp"
#include "sinew/sinew.hpp"

namespace sinew_test {

struct RiggedScene : RigSkeleton {
  sinew_status status = SINEW_OK;
  uint32_t count = 0;
  std::vector<std::string> names;

  RiggedScene(const MeshScene& scene, const sinew_rig_options& options, const sinew_model* model = bundled_rig_model(),
              size_t missing_bytes = 0) {
    const sinew_mesh mesh = scene.mesh_view();
    size_t bytes = 0;
    status = sinew_rig_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count, &options, &bytes);
    if (status != SINEW_OK) return;
    const sinew::Workspace block(bytes);
    std::memset(block.data(), 0x5A, bytes);
    // What a call leaves as it is shows.
    for (auto* const numbers : {&parents, &partners}) numbers->assign(numbers->size(), 77);
    for (auto* const bytes_of : {&flags, &classes}) bytes_of->assign(bytes_of->size(), 77);
    for (auto* const shares : {&confidence, &parent_confidence}) shares->assign(shares->size(), 77);
    status = sinew_rig(model, &mesh, &options, block.data(), bytes - missing_bytes, &outputs);
    count = outputs.joint_count;
    for (uint32_t j = 0; j < count; ++j) names.push_back(name(j));
  }

  bool same_as(const RiggedScene& other) const {
    return status == other.status && RigSkeleton::same_as(other) && outputs.plane == other.outputs.plane &&
           outputs.spread == other.outputs.spread;
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
