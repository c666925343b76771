// SPDX-License-Identifier: MIT
// Each rule of the target skeleton on a few square patches of mesh.
#include "sinew_data_sets/target_skeleton.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>

#include "expect_error.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"

namespace sinew {
namespace {

using namespace rigging;

// Joints, and squares of side 1 across z that move with them. A strip on joint 0 makes the longest side 10.
class Doll {
 public:
  uint32_t joint(const std::string& name, Vec3 position, int parent = -1) {
    character.joints.push_back({name, position, parent});
    return static_cast<uint32_t>(character.joints.size() - 1);
  }
  void patch(const std::vector<Influence>& row, Vec3 center, float half = 0.5f) { rectangle(row, center, half, half); }
  void strip() { rectangle({{0, 1}}, {0, 5, 0}, 0.5f, 5); }
  TargetSkeleton target() const { return target_skeleton(character); }

  Character character;

 private:
  void rectangle(const std::vector<Influence>& row, Vec3 center, float x, float y) {
    const auto first = static_cast<uint32_t>(character.vertices.size());
    for (const auto& [dx, dy] : {std::pair{-x, -y}, std::pair{x, -y}, std::pair{x, y}, std::pair{-x, y}}) {
      character.face_vertices.push_back(first + static_cast<uint32_t>(character.vertices.size() - first));
      character.vertices.push_back({center.x + dx, center.y + dy, center.z});
      character.influences.push_back(row);
    }
    character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
  }
};

std::vector<std::string> names_of(const TargetSkeleton& target) {
  std::vector<std::string> names;
  for (const TargetJoint& joint : target.joints) names.push_back(joint.name);
  return names;
}
std::vector<int> parents_of(const TargetSkeleton& target) {
  std::vector<int> parents;
  for (const TargetJoint& joint : target.joints) parents.push_back(joint.parent);
  return parents;
}
void expect_at(const TargetJoint& joint, double x, double y, double z) {
  EXPECT_NEAR(joint.position[0], x, 1e-6) << joint.name;
  EXPECT_NEAR(joint.position[1], y, 1e-6) << joint.name;
  EXPECT_NEAR(joint.position[2], z, 1e-6) << joint.name;
}

using Names = std::vector<std::string>;
using Parents = std::vector<int>;
using Owners = std::vector<uint32_t>;

TEST(TargetSkeleton, DetailsBelongToTheirParents) {
  Doll doll;
  doll.joint("Hips", {0, 5, 0});
  doll.joint("Hand.L", {3, 5, 0}, 0);
  doll.joint("Index.L", {4, 5, 0}, 1);
  doll.patch({{0, 1}}, {0, 5, 0});
  doll.patch({{1, 1}}, {3, 5, 0});
  doll.patch({{2, 1}}, {4.5f, 5, 0});
  const TargetSkeleton target = doll.target();
  EXPECT_EQ(names_of(target), (Names{"Hips", "Hand.L", "Hand.L_end"}));
  EXPECT_EQ(parents_of(target), (Parents{-1, 0, 1}));
  EXPECT_EQ(target.owners, (Owners{0, 1, 1}));
  EXPECT_EQ(target.joints[0].joint_class, kClassPelvis);
  EXPECT_EQ(target.joints[1].joint_class, kClassHand);
  EXPECT_NEAR(target.joints[0].mass, 1.0 / 3, 1e-12);
  EXPECT_NEAR(target.joints[1].mass, 2.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(target.side, 5.5);
  EXPECT_FALSE(target.joints[1].tip);
  EXPECT_TRUE(target.joints[2].tip);
  EXPECT_EQ(target.joints[2].joint_class, kClassHand);
  EXPECT_EQ(target.joints[2].source, 1u);
  expect_at(target.joints[2], 3 + 0.85 * 2, 5, 0);  // its vertices reach to x = 5
}

TEST(TargetSkeleton, UnboundJointsStayBetweenBoundOnes) {
  Doll doll;
  doll.joint("Hips", {0, 3, 0});
  doll.joint("Spine", {0, 5, 0}, 0);
  doll.joint("Head", {0, 8, 0}, 1);
  doll.joint("Bone.L", {3, 5, 0}, 0);
  doll.joint("Bone2.L", {4, 5, 0}, 3);
  const uint32_t light = doll.joint("Foot.L", {1, 0, 0}, 0);
  doll.strip();
  doll.patch({{2, 1}}, {0, 9, 0});
  doll.patch({{0, 0.99f}, {light, 0.01f}}, {1, 0, 0}, 0.01f);
  TargetSkeleton target = doll.target();
  // 4 of 12 vertices with a hundredth: 0.33 % of the vertices are enough.
  EXPECT_EQ(names_of(target), (Names{"Hips", "Spine", "Head", "Foot.L", "Head_end"}));
  for (size_t v = 8; v < 12; ++v) doll.character.influences[v] = {{0, 0.995f}, {light, 0.005f}};
  target = doll.target();
  EXPECT_EQ(names_of(target), (Names{"Hips", "Spine", "Head", "Head_end"}));
  EXPECT_EQ(parents_of(target), (Parents{-1, 0, 1, 2}));
  EXPECT_EQ(target.owners, (Owners{0, 1, 2, 0, 0, 0})) << "what is left out moves with its parent";
  EXPECT_EQ(target.joints[1].mass, 0);
}

TEST(TargetSkeleton, AnUnboundTopGoesAndTheHeaviestChildIsTheRoot) {
  Doll doll;
  doll.joint("Hips", {0, 5, 0}, 4);
  doll.joint("Cape", {0, 8.5f, 0}, 4);
  doll.joint("Chest", {0, 8, 0}, 0);
  doll.joint("Master", {0, 0, 0});
  doll.joint("Root", {0, 0.5f, 0}, 3);
  doll.strip();
  doll.patch({{1, 1}}, {0, 8, 1});
  doll.patch({{2, 1}}, {0, 9, 0});
  TargetSkeleton target = doll.target();
  EXPECT_EQ(names_of(target), (Names{"Hips", "Cape", "Chest", "Cape_end"}));
  EXPECT_EQ(parents_of(target), (Parents{-1, 2, 0, 1})) << "the cape hangs on the nearest joint of the body";
  EXPECT_EQ(target.owners[3], 0u) << "nothing is left above the master: the nearest joint";
  // Two roots in the file are the same.
  doll.character.joints[0].parent = doll.character.joints[1].parent = -1;
  doll.character.joints.resize(3);
  target = doll.target();
  EXPECT_EQ(parents_of(target), (Parents{-1, 2, 0, 1}));
}

TEST(TargetSkeleton, JointsAtOnePlaceAreOne) {
  Doll doll;
  doll.joint("Hips", {0, 1, 0});
  doll.joint("Neck", {0, 8, 0}, 0);
  doll.joint("Head", {0, 8.05f, 0}, 1);
  doll.joint("Ear.L", {1, 9, 0}, 2);
  doll.strip();
  doll.patch({{1, 1}}, {0, 8, 0}, 0.2f);
  doll.patch({{2, 1}}, {0, 8.5f, 0});
  doll.patch({{3, 1}}, {1, 9.5f, 0}, 0.3f);
  TargetSkeleton target = doll.target();
  EXPECT_EQ(names_of(target), (Names{"Hips", "Neck", "Ear.L", "Ear.L_end"}));
  EXPECT_EQ(parents_of(target), (Parents{-1, 0, 1, 2}));
  EXPECT_EQ(target.owners, (Owners{0, 1, 1, 2}));
  expect_at(target.joints[1], 0, 8.05f, 0);  // the heavier one's position
  EXPECT_EQ(target.joints[1].source, 2u);
  EXPECT_EQ(target.joints[1].joint_class, kClassNeck);
  doll.character.joints[1].name = "Bone.007";
  EXPECT_EQ(doll.target().joints[1].joint_class, kClassHead) << "a name that says nothing takes the other's class";
  doll.character.joints[2].position.y = 8.15f;
  EXPECT_EQ(doll.target().owners, (Owners{0, 1, 2, 3})) << "1.5 % apart";
}

TEST(TargetSkeleton, PelvisesThatAreNearAreOne) {
  Doll doll;
  doll.joint("Hips", {0, 5, 0});
  doll.joint("Pelvis", {0, 5.7f, 0}, 0);
  doll.joint("Spine", {0, 5.7f, 0.5f}, 1);
  doll.strip();
  doll.patch({{1, 1}}, {0, 6, 0});
  doll.patch({{2, 1}}, {0, 8, 0});
  EXPECT_EQ(names_of(doll.target()), (Names{"Hips", "Spine", "Spine_end"})) << "7 % apart; the spine is 5 % away";
  doll.character.joints[1].position.y = 5.9f;
  EXPECT_EQ(names_of(doll.target()), (Names{"Hips", "Pelvis", "Spine", "Spine_end"}));
}

TEST(TargetSkeleton, TheFilesOwnEndIsTakenWhereThereIsOne) {
  Doll doll;
  doll.joint("Hips", {0, 1, 0});
  doll.joint("Head", {0, 8, 0}, 0);
  doll.strip();
  doll.patch({{1, 1}}, {0, 9, 0});
  const auto end = [&] { return doll.target().joints.back(); };
  expect_at(end(), 0, 8 + 0.85 * 1.5, 0);
  doll.joint("Hat", {0, 9.5f, 0}, 1);
  expect_at(end(), 0, 8 + 0.85 * 1.5, 0);  // no end and no detail: it says nothing of the head
  doll.joint("Head_END", {0, 9, 1}, 1);
  expect_at(end(), 0, 9, 1);
  EXPECT_EQ(doll.target().owners, (Owners{0, 1, 1, 1}));
  doll.joint("Head_end2", {0, 8.05f, 0}, 1);
  expect_at(end(), 0, 9, 1);  // 0.5 % away is none
  doll.joint("Eye.L", {0.5f, 9, 0}, 1);
  expect_at(end(), 0, 8 + 0.85 * 1.5, 0);  // a weightless detail may be one: they are two
}

TEST(TargetSkeleton, NoEndWithoutADirection) {
  Doll doll;
  doll.joint("Hips", {0, 1, 0});
  doll.joint("Head", {0, 9, 0}, 0);
  doll.strip();
  doll.patch({{1, 1}}, {0, 9, 0});
  EXPECT_EQ(names_of(doll.target()), (Names{"Hips", "Head"})) << "as much of it on every side";
}

TEST(TargetSkeleton, WeakLeavesEndWhereTheirVerticesDo) {
  Doll doll;
  doll.joint("Hips", {0, 1, 0});
  doll.joint("Head", {0, 8, 0}, 0);
  doll.strip();
  doll.patch({{0, 0.7f}, {1, 0.3f}}, {0, 9, 0});
  expect_at(doll.target().joints.back(), 0, 8 + 0.85 * 1.5, 0);
  for (size_t v = 4; v < 8; ++v) doll.character.influences[v] = {{0, 0.9f}, {1, 0.1f}};
  EXPECT_EQ(names_of(doll.target()), (Names{"Hips", "Head"})) << "no vertex follows it by a fifth";
}

TEST(TargetSkeleton, RefusesWhatHasNoTarget) {
  Doll doll;
  doll.strip();
  EXPECT_ERROR(doll.target(), "no joints");
  doll.joint("Hips", {0, 1, 0});
  doll.character.name = "hero";
  EXPECT_EQ(names_of(doll.target()), (Names{"Hips", "Hips_end"})) << "one joint is enough";
  Doll broken = doll;
  broken.character.influences.clear();
  EXPECT_ERROR(broken.target(), "hero", "no weights");
  broken = doll;
  broken.character.influences[0] = {{7, 1}};
  EXPECT_ERROR(broken.target(), "joint 7 of 1");
  broken = doll;
  broken.character.face_vertices[2] = 99;
  EXPECT_ERROR(broken.target(), "vertex 99 of 4");
  broken = doll;
  broken.character.vertices.assign(4, {1, 1, 1});
  EXPECT_ERROR(broken.target(), "one position");
  broken = doll;
  broken.joint("a", {0, 0, 0}, 2);
  broken.joint("b", {0, 0, 0}, 1);
  EXPECT_ERROR(broken.target(), "cycle");
}

TEST(TargetSkeleton, JointsOfAFileAreReadBackAsTheyWere) {
  TargetSkeleton target;
  const auto add = [&](const std::string& name, int parent, bool tip) {
    TargetJoint joint;
    joint.name = name;
    joint.parent = parent;
    joint.tip = tip;
    joint.position = {1, 2, static_cast<double>(target.joints.size())};
    target.joints.push_back(joint);
  };
  add("A", -1, false);
  add("A_end", 0, false);
  add("B", 1, false);
  add("Tail_End2", 0, false);
  add("A_end", 2, true);
  const std::vector<Joint> joints = target_joints(target);
  ASSERT_EQ(joints.size(), 5u);
  EXPECT_EQ(joints[1].name, "A_end") << "it has a child: nobody takes it for a bone end";
  EXPECT_EQ(joints[3].name, "Tail_End2_joint");
  EXPECT_EQ(joints[4].name, "A_end1");
  EXPECT_EQ(joints[4].parent, 2);
  EXPECT_EQ(joints[4].position.z, 4);
  EXPECT_TRUE(names_bone_end("A_end1"));
  EXPECT_FALSE(names_bone_end("x_TIP"));
  EXPECT_FALSE(names_bone_end("Tail_End2_joint"));
  EXPECT_FALSE(names_bone_end("legend"));
  EXPECT_FALSE(names_bone_end("end"));
}

}  // namespace
}  // namespace sinew
