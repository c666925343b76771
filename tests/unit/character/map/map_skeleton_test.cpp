// SPDX-License-Identifier: MIT
// Rigs from files: what animate reads as a motion, map reads as a skeleton.
#include "sinew_character/map_skeleton.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "make_glb.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

TEST(MapRig, NodesThatMoveWithoutAMeshAreOne) {
  const TempFolder folder;
  GlbBuilder builder;
  builder.root({{"name", "hips"}, {"children", {1}}});
  builder.add("nodes", {{"name", "spine"}, {"translation", {0, 1, 0}}});
  EXPECT_ERROR((void)read_map_rig(folder.write("still.glb", builder.glb())), "still.glb", "without a skin");
  nlohmann::json animation = {
      {"name", "a"}, {"samplers", nlohmann::json::array()}, {"channels", nlohmann::json::array()}};
  animation["samplers"].push_back(
      {{"input", builder.accessor(std::vector<float>{0, 1}, "SCALAR")},
       {"output", builder.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0.6f, 0.8f}, "VEC4")}});
  animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}});
  builder.add("animations", animation);
  const MapRig rig = read_map_rig(folder.write("moving.glb", builder.glb()));
  ASSERT_EQ(rig.joints.size(), 2u);
  EXPECT_EQ(rig.joints[1].name, "spine");
  EXPECT_EQ(rig.joints[1].position.y, 1);
}

TEST(MapRig, AMotionIsSeenInItsStance) {
  const TempFolder folder;
  const Motion walk = walking_person(), written = with_random_axes(walk);
  const std::string path = folder.path() + "/walk.bvh";
  write_bvh(path, written, written.clips[0]);
  const MapRig rig = read_map_rig(path);
  for (const Joint& joint : rig.joints) {
    if (joint.name == "Head") {
      EXPECT_GT(joint.position.y, 0.5f);
    }
    if (joint.name == "LeftFoot") {
      EXPECT_LT(joint.position.y, -0.7f);
    }
  }
}

}  // namespace
}  // namespace sinew
