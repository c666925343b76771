// SPDX-License-Identifier: MIT
// rig.txt: what is read, what is refused and with which words, what is written.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

const char kOneFace[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const char kRig[] =
    "joints hip 0 1 0\njoints knee 0 0.5 0.1\nroot hip\nskin 0 hip 0.75 knee 0.25\nskin 2 knee 1\nhier hip knee\n";

Character rigged(const std::string& rig) {
  const TempFolder folder;
  folder.write("dog.obj", kOneFace);
  return read_character(folder.write("dog.rig.txt", rig));
}

TEST(Rig, ReadsJointsHierarchyAndWeights) {
  const Character c = rigged(kRig);
  EXPECT_EQ(c.name, "dog");
  ASSERT_EQ(c.joints.size(), 2u);
  EXPECT_EQ(c.joints[1].name, "knee");
  EXPECT_EQ(c.joints[1].parent, 0);
  EXPECT_EQ(c.joints[0].parent, -1);
  EXPECT_EQ(c.joints[1].position.z, 0.1f);
  ASSERT_EQ(c.influences.size(), 3u);
  EXPECT_EQ(c.influences[0].size(), 2u);
  EXPECT_EQ(c.influences[0][1].weight, 0.25f);
  EXPECT_TRUE(c.influences[1].empty());
}

TEST(Rig, AnyOrderCrlfCommentsAndSeveralRoots) {
  const Character c = rigged(
      "# made by hand\r\nhier hip knee\r\nskin 1 knee 0.5 hip 0 \r\n\r\nroot hip\r\njoints knee 0 0 0\r\njoints hip 1 "
      "1 1\r\njoints prop 2 2 2\r\n");
  EXPECT_EQ(c.joints[0].parent, 1);
  EXPECT_EQ(c.joints[2].parent, -1);
  EXPECT_EQ(c.influences[1].size(), 1u);  // a weight of 0 is none
}

TEST(Rig, ErrorsNameFileAndLine) {
  const std::string head = "joints hip 0 1 0\njoints knee 0 0.5 0\nroot hip\nhier hip knee\n";
  EXPECT_ERROR(rigged(head + "bone a b\n"), "dog.rig.txt:5:", "'bone'");
  EXPECT_ERROR(rigged(head + "joints knee 0 0 0\n"), "dog.rig.txt:5:", "once", "line 2", "'knee'");
  EXPECT_ERROR(rigged(head + "joints toe 0 0\n"), "dog.rig.txt:5:", "joints NAME x y z");
  EXPECT_ERROR(rigged(head + "joints toe 0 nan 0\n"), "dog.rig.txt:5:", "'nan'");
  EXPECT_ERROR(rigged(head + "skin 0 toe 1\n"), "dog.rig.txt:5:", "'toe'");
  EXPECT_ERROR(rigged(head + "skin 3 hip 1\n"), "dog.rig.txt:5:", "below 3", "'3'");
  EXPECT_ERROR(rigged(head + "skin -1 hip 1\n"), "dog.rig.txt:5:", "'-1'");
  EXPECT_ERROR(rigged(head + "skin 0 hip\n"), "dog.rig.txt:5:", "pairs");
  EXPECT_ERROR(rigged(head + "skin 0 hip nan\n"), "dog.rig.txt:5:", "weight", "'nan'");
  EXPECT_ERROR(rigged(head + "skin 0 hip -0.5\n"), "dog.rig.txt:5:", "'-0.5'");
  EXPECT_ERROR(rigged(head + "skin 0 hip 0.5 hip 0.5\n"), "dog.rig.txt:5:", "once per vertex");
  EXPECT_ERROR(rigged(head + "skin 0 hip 1\nskin 0 hip 1\n"), "dog.rig.txt:6:", "line 5");
  EXPECT_ERROR(rigged(head + "hier toe knee\n"), "dog.rig.txt:5:", "'toe'");
  EXPECT_ERROR(rigged(head + "hier knee knee\n"), "dog.rig.txt:5:", "one parent", "'hip'");
  EXPECT_ERROR(rigged(head + "hier knee hip\n"), "dog.rig.txt", "cycle");
  EXPECT_ERROR(rigged(head + "root knee\n"), "dog.rig.txt:5:", "line 3");
  EXPECT_ERROR(rigged("joints a 0 0 0\njoints b 0 0 0\nhier a b\nroot b\n"), "dog.rig.txt:4:", "without parent");
  EXPECT_ERROR(rigged("joints a 0 0 0\n"), "dog.rig.txt", "root NAME");
  EXPECT_ERROR(rigged("root a\n"), "dog.rig.txt", "joints");
  EXPECT_ERROR(rigged(""), "dog.rig.txt", "empty");
  EXPECT_ERROR(rigged(std::string("joints\0", 7)), "dog.rig.txt", "binary");
}

TEST(Rig, ABrokenRigLeavesTheMeshAsItWas) {
  const TempFolder folder;
  Character c = rigged(kRig);
  EXPECT_ERROR(read_skeleton(folder.write("bad.rig.txt", "joints a 0 0 0\nroot a\nskin 0 a -1\n"), true, &c),
               "bad.rig.txt:3:");
  EXPECT_EQ(c.joints.size(), 2u);
  EXPECT_EQ(c.influences.size(), 3u);
}

TEST(Rig, SkeletonAloneIgnoresVertexNumbers) {
  const TempFolder folder;
  Character c = read_obj(folder.write("mesh.obj", kOneFace));
  read_skeleton(folder.write("s.txt", "joints a 0 0 0\nroot a\nskin 77 a 1\n"), false, &c);
  EXPECT_EQ(c.joints.size(), 1u);
  EXPECT_TRUE(c.influences.empty());
}

TEST(Rig, WritesNamesWithoutBlanks) {
  const TempFolder folder;
  Character c = rigged(kRig);
  c.joints[0].name = "left hip";
  c.joints[1].name = "left_hip";
  c.joints.push_back({"", {}, 0});
  c.joints.push_back({"left_hip_2", {}, 0});
  c.influences[0].push_back({2, 4e-7f});  // prints as nothing
  write_rig(folder.file("out.rig.txt"), c);
  EXPECT_NE(folder.text_of("out.rig.txt").find("skin 0 left_hip 0.750000 left_hip_3 0.250000\n"), std::string::npos);
  Character again = read_obj(folder.write("mesh.obj", kOneFace));
  read_skeleton(folder.file("out.rig.txt"), true, &again);
  EXPECT_EQ(again.joints[0].name, "left_hip");
  EXPECT_EQ(again.joints[1].name, "left_hip_3");
  EXPECT_EQ(again.joints[2].name, "joint_2");
  EXPECT_EQ(again.joints[3].name, "left_hip_2");
}

TEST(Rig, RefusesToWriteWhatItCouldNotRead) {
  const TempFolder folder;
  Character c = rigged(kRig);
  c.influences[0].push_back({9, 0.5f});
  EXPECT_ERROR(write_rig(folder.file("o.rig.txt"), c), "vertex 0", "joint 9 of 2");
  c = rigged(kRig);
  c.joints[0].parent = 1;
  EXPECT_ERROR(write_rig(folder.file("o.rig.txt"), c), "root");
  c.joints.clear();
  EXPECT_ERROR(write_rig(folder.file("o.rig.txt"), c), "joints");
  EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace sinew
