// SPDX-License-Identifier: MIT
// OBJ: what is read, what is refused and with which words, what is written.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
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

// tex: some exporter's.
TEST(Obj, StatementsThatNoObjHasAreSkippedAndTold) {
  const Character c = obj(std::string(kTriangle) + "tex skin.png\nf 1 2 3\ntex other.png\n");
  EXPECT_EQ(c.face_count(), 1u);
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes[0].find("'tex' in line 4"), std::string::npos);
  EXPECT_NE(c.notes[0].find("1 more line"), std::string::npos);
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
  EXPECT_ERROR(obj(head + "hello,world\n"), "mesh.obj:4:", "'hello,world'");
  EXPECT_ERROR(obj(head + "3 1 2\n"), "mesh.obj:4:", "'3'");
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
  EXPECT_ERROR(read_mesh(folder.write("a.xyz", "x")), "a.xyz", "extension");
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
  // 0.05 s when optimized; the limit only catches a step that grows with the square.
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

}  // namespace
}  // namespace sinew
