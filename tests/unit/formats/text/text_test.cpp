// SPDX-License-Identifier: MIT
// OBJ, rig.txt, files and folders: what is read, what is refused and with which words, what is left on disk.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

using namespace sinew;

namespace {

Character obj(const std::string& text) {
  const TempFolder folder;
  return read_obj(folder.write("mesh.obj", text));
}

const char kTriangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Obj, KeepsPolygonsAndTheFilesVertexOrder) {
  const Character c = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\nf 1 2 3 5 4\nf 4 3 2 1\n");
  EXPECT_EQ(c.vertices.size(), 5u);
  EXPECT_EQ(c.vertices[4].y, 2);
  EXPECT_EQ(c.face_offsets, (std::vector<uint32_t>{0, 5, 9}));
  EXPECT_EQ(c.face_vertices, (std::vector<uint32_t>{0, 1, 2, 4, 3, 3, 2, 1, 0}));
  EXPECT_TRUE(c.corner_uvs.empty());
  EXPECT_TRUE(c.corner_normals.empty());
}

TEST(Obj, PolygonsOfMoreThan255Corners) {
  std::string text, face = "f";
  for (int i = 0; i < 300; ++i) {
    text += "v " + std::to_string(i) + " 0 " + std::to_string(i * i) + "\n";
    face += " " + std::to_string(i + 1);
  }
  EXPECT_EQ(obj(text + face + "\n").face_vertices.size(), 300u);
}

TEST(Obj, NegativeIndicesCountBackFromWhereTheyStand) {
  const Character c = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nvt 0 0\nvt 0.5 0.25\nf -4/-2 -1/-1 2/1\n");
  EXPECT_EQ(c.face_vertices, (std::vector<uint32_t>{0, 1, 2, 0, 3, 1}));
  EXPECT_EQ(c.corner_uvs[4], (std::array<float, 2>{0.5f, 0.25f}));
}

TEST(Obj, CarriageReturnsCommentsTabsBomAndContinuedLines) {
  const std::string text =
      "\xef\xbb\xbf# a comment\r\n\r\no  thing \r\nv\t0 0 0\r\n  v 1 0 0  \r\nv 0 1 \\\r\n 5\r\nf 1 2 3";
  const Character c = obj(text);
  EXPECT_EQ(c.vertices.size(), 3u);
  EXPECT_EQ(c.vertices[2].z, 5);
  EXPECT_EQ(c.group_names[0], "thing");
  EXPECT_EQ(c.face_count(), 1u);
  EXPECT_EQ(obj("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").face_count(), 1u);  // the oldest line ends
}

TEST(Obj, GroupsObjectsAndMaterialsPerFace) {
  const Character c = obj(std::string("o body\r\n") +
                          "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvn 0 0 2\r\nusemtl skin\r\nf 1//1 2//1 3//1\r\ng arm "
                          "left\r\nusemtl cloth\r\nf 3 \\\r\n 2 1\r\nusemtl skin\r\nf 1 3 2\r\n");
  EXPECT_EQ(c.group_names, (std::vector<std::string>{"body", "arm left"}));
  EXPECT_EQ(c.face_groups, (std::vector<int>{0, 1, 1}));
  EXPECT_EQ(c.material_names, (std::vector<std::string>{"skin", "cloth"}));
  EXPECT_EQ(c.face_materials, (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(c.corner_normals.size(), 9u);
  EXPECT_EQ(c.corner_normals[0].z, 2);
  EXPECT_EQ(c.corner_normals[3].z, 0);  // not given
}

TEST(Obj, LinesAndPointsAndFreeFormStatementsAreSkipped) {
  const Character c = obj(std::string(kTriangle) + "l 1 2\np 1\ns off\nmtllib a.mtl\nf 1 2 3\nvp 0.1 0.2\n");
  EXPECT_EQ(c.face_count(), 1u);
}

TEST(Obj, ErrorsNameFileLineExpectedAndFound) {
  const std::string head = kTriangle;
  EXPECT_ERROR(obj(head + "f 1 2 0\n"), "mesh.obj:4:", "expected", "from 1", "found '0'");
  EXPECT_ERROR(obj(head + "f 1 2 4\n"), "mesh.obj:4:", "up to 3", "'4'");
  EXPECT_ERROR(obj(head + "f 1 2 -4\n"), "mesh.obj:4:", "-3", "'-4'");
  EXPECT_ERROR(obj(head + "f 1 2 x\n"), "mesh.obj:4:", "'x'");
  EXPECT_ERROR(obj(head + "f +-3 2 1\n"), "mesh.obj:4:", "vertex number", "'+-3'");
  EXPECT_ERROR(obj(head + "v 0 +-1 0\n"), "mesh.obj:4:", "finite number", "'+-1'");
  EXPECT_ERROR(obj(head + "f 1/ 2 3\n"), "mesh.obj:4:", "texture coordinate", "'1/'");
  EXPECT_ERROR(obj(head + "f 1/2 2 3\n"), "mesh.obj:4:", "texture coordinate", "up to 0");
  EXPECT_ERROR(obj(head + "f 1//1 2 3\n"), "mesh.obj:4:", "normal");
  EXPECT_ERROR(obj(head + "f 1 2\n"), "mesh.obj:4:", "3 corners");
  EXPECT_ERROR(obj(head + "f 99999999999999999999 1 2\n"), "mesh.obj:4:");
  EXPECT_ERROR(obj(head + "f 2147483648 1 2\n"), "mesh.obj:4:");
  EXPECT_ERROR(obj("v 0 0\n"), "mesh.obj:1:", "3 to 7 numbers");
  EXPECT_ERROR(obj("v 0 0 nan\n"), "mesh.obj:1:", "finite", "'nan'");
  EXPECT_ERROR(obj("v 0 -inf 0\n"), "mesh.obj:1:", "'-inf'");
  EXPECT_ERROR(obj("v 0 1e39 0\n"), "mesh.obj:1:", "'1e39'");
  EXPECT_ERROR(obj("v 0 1,5 0\n"), "mesh.obj:1:", "'1,5'");
  EXPECT_ERROR(obj(head + "vt a\n"), "mesh.obj:4:");
  EXPECT_ERROR(obj(head + "vn 1 0\n"), "mesh.obj:4:");
  EXPECT_ERROR(obj(head + "hello world\n"), "mesh.obj:4:", "'hello'");
  EXPECT_ERROR(obj("# nothing\n"), "mesh.obj", "vertices", "none in 1 lines");
  EXPECT_ERROR(obj(""), "mesh.obj", "empty file");
  EXPECT_ERROR(obj(std::string("\x7f"
                               "ELF\0\0\1",
                               7)),
               "mesh.obj", "binary");
  EXPECT_ERROR(obj("\x80\x99rubbish\n"), "mesh.obj:1:", "\\x80");
  const TempFolder folder;
  EXPECT_ERROR(read_obj(folder.path()), folder.path(), "directory");
  EXPECT_ERROR(read_obj(folder.file("no.obj")), "no.obj", "no such file");
  EXPECT_ERROR(read_mesh(folder.write("a.fbx", "x")), "a.fbx", "extension");
}

TEST(Obj, AcceptsNumbersInEveryUsualForm) {
  const Character c =
      obj("v +1 -.5 2.\nv 1e-3 1E+2 1e-400\nv 0 0 0 1\nv 0 0 0 0.1 0.2 0.3\nv 1 0e491 -0E400\nf 1 2 3\n");
  EXPECT_EQ(c.vertices[0].y, -0.5f);
  EXPECT_EQ(c.vertices[4].y, 0);
  EXPECT_EQ(c.vertices[4].z, 0);
  EXPECT_EQ(c.vertices[1].y, 100);
  EXPECT_EQ(c.vertices[1].z, 0);
}

TEST(Obj, WritesNormalsToTheSignOfTheirZeros) {
  const TempFolder folder;
  Character c = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn -0 0 1\nf 1//1 2//2 3//1\n");
  write_obj(folder.file("a.obj"), c);
  const Character again = read_obj(folder.file("a.obj"));
  EXPECT_FALSE(std::signbit(again.corner_normals[0].x));
  EXPECT_TRUE(std::signbit(again.corner_normals[1].x));
}

TEST(Obj, FormFeedsAndVerticalTabsPartWords) {
  const Character c = obj("v 0\f0 0\nv 1\v0 0\nv 0 1 0\nf 1\f2 \v3\n");
  EXPECT_EQ(c.vertices[1].x, 1);
  EXPECT_EQ(c.face_vertices, (std::vector<uint32_t>{0, 1, 2}));
}

TEST(Obj, ReadsHundredThousandVerticesFast) {
  std::string text;
  const int side = 320;
  for (int i = 0; i < side * side; ++i)
    text += "v " + std::to_string(i % side * 0.01) + " " + std::to_string(i / side * 0.01) + " 0.125\n";
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const int v = y * side + x + 1;
      text += "f " + std::to_string(v) + " " + std::to_string(v + 1) + " " + std::to_string(v + side + 1) + " " +
              std::to_string(v + side) + "\n";
    }
  const TempFolder folder;
  const std::string path = folder.write("big.obj", text);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(read_obj(path).vertices.size(), 102400u);
  // 0.05 s when optimised; the limit only catches a step that grows with the square.
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 5.0);
}

TEST(Obj, NamesNeverEndALineOrJoinTwo) {
  const TempFolder folder;
  Character c = read_obj(folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  for (const std::string name : {"cloth\\", "cloth\\ ", "two\nf 1 1 1", "\\", "\r"}) {
    c.material_names = c.group_names = {name};
    c.face_materials = c.face_groups = {0};
    write_obj(folder.file("out.obj"), c);
    const Character again = read_obj(folder.file("out.obj"));
    EXPECT_EQ(again.face_vertices, c.face_vertices) << name;
    EXPECT_EQ(again.material_names.size(), 1u) << name;
  }
}

TEST(Obj, WritesWhatItReads) {
  const TempFolder folder;
  const std::string text = std::string(kTriangle) +
                           "v 0.1 1e-7 -3.4028235e38\nvt 0.5 1\nvt 0 0.1\nvn 0 0 1\ng a b\nusemtl m\nf 1/1/1 2/2/1 "
                           "3/1/1\nf 1/2/1 3/1/1 4/1/1 2/2/1\n";
  const Character a = read_obj(folder.write("a.obj", text));
  write_obj(folder.file("b.obj"), a);
  const Character b = read_obj(folder.file("b.obj"));
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (size_t v = 0; v < a.vertices.size(); ++v) {
    EXPECT_EQ(a.vertices[v].x, b.vertices[v].x);
    EXPECT_EQ(a.vertices[v].y, b.vertices[v].y);
    EXPECT_EQ(a.vertices[v].z, b.vertices[v].z);
  }
  EXPECT_EQ(a.face_offsets, b.face_offsets);
  EXPECT_EQ(a.face_vertices, b.face_vertices);
  EXPECT_EQ(a.corner_uvs, b.corner_uvs);
  EXPECT_EQ(a.group_names, b.group_names);
  EXPECT_EQ(a.face_groups, b.face_groups);
  EXPECT_EQ(a.material_names, b.material_names);
  write_obj(folder.file("c.obj"), b);
  EXPECT_EQ(folder.text_of("b.obj"), folder.text_of("c.obj"));
}

// ---- rig.txt

const char kRig[] =
    "joints hip 0 1 0\njoints knee 0 0.5 0.1\nroot hip\nskin 0 hip 0.75 knee 0.25\nskin 2 knee 1\nhier hip knee\n";

Character rigged(const std::string& rig) {
  const TempFolder folder;
  folder.write("dog.obj", std::string(kTriangle) + "f 1 2 3\n");
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
  Character c = obj(std::string(kTriangle) + "f 1 2 3\n");
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
  Character again = obj(std::string(kTriangle) + "f 1 2 3\n");
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

// ---- files and folders

TEST(Files, AFailedWriteLeavesTheTargetAndNoRubbish) {
  const TempFolder folder;
  folder.write("old.txt", "old");
  write_text_file(folder.file("old.txt"), "new");
  EXPECT_EQ(folder.text_of("old.txt"), "new");
  EXPECT_ERROR(write_text_file(folder.file("missing/x.txt"), "x"), "missing/x.txt", "does not exist");
  std::filesystem::create_directory(folder.file("dir"));
  EXPECT_ERROR(write_text_file(folder.file("dir"), "x"), "dir", "directory");
  EXPECT_EQ(folder.file_count(), 2u);
  const Character empty;
  EXPECT_ERROR(write_glb(folder.file("old.txt"), empty), "old.txt", "without faces");
  EXPECT_EQ(folder.text_of("old.txt"), "new");
}

TEST(Files, AFullDiskLeavesTheTargetAndNoRubbish) {
  const TempFolder folder;
  folder.write("old.txt", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 4096;
  signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  std::string message;
  try {
    write_text_file(folder.file("old.txt"), std::string(100000, 'x'));
  } catch (const Error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_NE(message.find("cannot write"), std::string::npos) << message;
  EXPECT_EQ(folder.text_of("old.txt"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Files, FollowsLinksAndWritesDevices) {
  const TempFolder folder;
  folder.write("real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder.file("link.txt"));
  write_text_file(folder.file("link.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(folder.text_of("real.txt"), "new");
  EXPECT_NO_THROW(write_text_file("/dev/null", "gone"));
}

TEST(Folders, ListsPairsAndGltfSortedByName) {
  const TempFolder folder;
  for (const char* name : {"b__2.obj", "b__2.rig.txt", "a__1.GLB", "c.obj", "d.rig.txt", "e__.vrm", "readme.txt"})
    folder.write(name, "x");
  const std::vector<std::string> found = list_characters(folder.path());
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0], folder.file("a__1.GLB"));
  EXPECT_EQ(found[1], folder.file("b__2.obj"));
  EXPECT_EQ(family_of("b__2"), "b");
  EXPECT_EQ(family_of("b_2"), "all");
  EXPECT_ERROR(list_characters(folder.file("nowhere")), "nowhere");
}

TEST(Folders, ACharacterWithoutItsRigIsAnError) {
  const TempFolder folder;
  EXPECT_ERROR(read_character(folder.write("cat.obj", std::string(kTriangle) + "f 1 2 3\n")), "cat.rig.txt",
               "no such file");
}

}  // namespace
