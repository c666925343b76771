// SPDX-License-Identifier: MIT
// Several people in one file: one of them by name or number; a body's own limbs are none.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

// Hips with legs, a spine, arms and a head: 15 joints.
void add_person(Motion* motion, const std::string& name, int parent, double x) {
  const auto add = [&](const char* joint, int above, Point3 offset) {
    motion->joints.push_back({name + joint, above, offset});
    return static_cast<int>(motion->joints.size()) - 1;
  };
  const int hips = add("", parent, {x, 1, 0}), spine = add(".spine", hips, {0, 0.3, 0});
  add(".head", spine, {0, 0.3, 0});
  for (const double side : {1.0, -1.0}) {
    const std::string s = side > 0 ? ".l" : ".r";
    int arm = spine, leg = hips;
    for (const char* part : {".arm", ".fore", ".hand"}) arm = add((part + s).c_str(), arm, {0.3 * side, 0, 0});
    for (const char* part : {".thigh", ".calf", ".foot"}) leg = add((part + s).c_str(), leg, {0, -0.5, 0});
  }
}
void add_frames(Motion* motion) {
  Clip& clip = motion->clips.emplace_back();
  clip.name = "clip";
  for (int f = 0; f < 2; ++f) {
    MotionFrame& frame = clip.frames.emplace_back();
    for (const MotionJoint& joint : motion->joints) {
      frame.rotations.push_back(kNoRotation4);
      frame.translations.push_back(joint.offset);
      frame.translations.back()[2] = f;
    }
  }
}
Motion two_people(bool carried) {
  Motion motion;
  if (carried) motion.joints.push_back({"scene", -1, {0, 0, 5}});
  add_person(&motion, "ann", carried ? 0 : -1, 0);
  add_person(&motion, "bob", carried ? 0 : -1, 2);
  add_frames(&motion);
  return motion;
}

TEST(Actors, OneOfSeveralByNameOrNumber) {
  for (const bool carried : {false, true}) {
    const Motion motion = two_people(carried);
    const std::optional<Motion> bob = one_actor(motion, "two.fbx", "bob"), first = one_actor(motion, "two.fbx", "");
    ASSERT_TRUE(bob && first);
    EXPECT_EQ(bob->joints.size(), carried ? 16u : 15u);
    EXPECT_EQ(rest_joints(*bob).back().name, "bob.foot.r");
    EXPECT_EQ(rest_joints(*bob).back().position.x, 2);
    EXPECT_EQ(rest_joints(*bob).back().position.z, carried ? 5 : 0) << "what carries it stays";
    ASSERT_EQ(bob->clips.size(), 1u);
    EXPECT_EQ(bob->clips[0].frames[1].rotations.size(), bob->joints.size());
    EXPECT_EQ(bob->clips[0].frames[1].translations.back()[1], -0.5);
    EXPECT_EQ(bob->clips[0].frames[1].translations.back()[2], 1);
    EXPECT_TRUE(bob->notes.empty());
    EXPECT_EQ(first->joints.back().name, "ann.foot.r");
    ASSERT_EQ(first->notes.size(), 1u);
    EXPECT_EQ(first->notes[0], "has 2 actors, 'ann', 'bob'; the first one plays, choose another with --actor");
    EXPECT_EQ(one_actor(motion, "two.fbx", "1")->joints.back().name, "bob.foot.r");
    EXPECT_ERROR(one_actor(motion, "two.fbx", "eve"), "two.fbx", "one of its 2 actors, 'ann', 'bob', found 'eve'");
    EXPECT_ERROR(one_actor(motion, "two.fbx", "2"), "found '2'");
  }
}

TEST(Actors, ABodyIsOne) {
  Motion one;
  one.joints.push_back({"armature", -1, {}});
  add_person(&one, "ann", 0, 0);
  add_frames(&one);
  EXPECT_FALSE(one_actor(one, "one.fbx", ""));
  EXPECT_TRUE(one_actor(one, "one.fbx", "armature")) << "its only root";
  EXPECT_ERROR(one_actor(one, "one.fbx", "ann.spine"), "one of its 1 actors, 'armature'");
  Motion tentacles;  // alike, but without ends of their own
  tentacles.joints.push_back({"body", -1, {}});
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 9; ++j)
      tentacles.joints.push_back({"t", j == 0 ? 0 : static_cast<int>(tentacles.joints.size()) - 1, {1, 0, 0}});
  add_frames(&tentacles);
  EXPECT_FALSE(one_actor(tentacles, "octopus.fbx", ""));
  Motion arms;  // a trunk without its pelvis, arms with hands
  arms.joints.push_back({"chest", -1, {0, 1.4, 0}});
  arms.joints.push_back({"head", 0, {0, 0.3, 0}});
  for (const double side : {1.0, -1.0}) {
    int above = 0;
    for (int j = 0; j < 3; ++j, above = static_cast<int>(arms.joints.size()) - 1)
      arms.joints.push_back({"arm", above, {0.25 * side, -0.05, 0}});
    for (int finger = 0; finger < 5; ++finger) arms.joints.push_back({"finger", above, {0.1 * side, 0, 0.02 * finger}});
  }
  add_frames(&arms);
  EXPECT_FALSE(one_actor(arms, "bust.glb", ""));
  Motion unlike = two_people(false);
  unlike.joints.push_back({"bob.tail", 15, {0, 0, -1}});
  EXPECT_FALSE(one_actor(unlike, "two.fbx", "")) << "who is meant is not known, so all are";
  EXPECT_ERROR(one_actor(Motion(), "none.bvh", "0"), "none.bvh", "of which there are none");
}

}  // namespace
}  // namespace sinew
