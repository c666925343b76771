// SPDX-License-Identifier: MIT
#include "sinew_formats/file_kinds.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace sinew {
namespace {

TEST(FileKinds, AreFoundByTheLongestExtensionInAnyCase) {
  ASSERT_NE(file_kind("a/hero.RIG.TXT"), nullptr);
  EXPECT_STREQ(file_kind("a/hero.RIG.TXT")->extension, ".rig.txt");
  EXPECT_STREQ(file_kind("hero.txt")->extension, ".txt");
  EXPECT_EQ(file_kind("hero.blend"), nullptr);
  EXPECT_EQ(file_kind(".glb"), nullptr) << "a name is longer than its extension";
  EXPECT_TRUE(has_use("x.vrm", kReadsMesh | kWritesMotion));
  EXPECT_TRUE(has_use("x.fbx", kWritesCharacter | kWritesMotion));
  EXPECT_TRUE(has_use("x.usdz", kWritesSkin | kWritesWithMesh | kWritesCharacter | kWritesMotion));
  EXPECT_FALSE(has_use("x.usdz", kReadsMesh) || has_use("x.usdz", kReadsMotion));
  EXPECT_FALSE(has_use("x.dae", kWritesCharacter));
}

TEST(FileKinds, RowsStandOnceAndBeforeWhatTheyEndWith) {
  const std::vector<FileKind>& kinds = file_kinds();
  std::set<std::string> seen;
  for (size_t i = 0; i < kinds.size(); ++i) {
    EXPECT_TRUE(seen.insert(kinds[i].extension).second) << kinds[i].extension;
    EXPECT_EQ(file_kind(std::string("x") + kinds[i].extension), &kinds[i]) << kinds[i].extension;
    EXPECT_NE(kinds[i].uses, 0u);
  }
  EXPECT_EQ(extensions_text(kReadsMesh),
            ".obj, .gltf, .glb, .vrm, .fbx, .dae, .b3d, .x, .mesh.xml, .mesh, .md5mesh, .ms3d, .smd, .iqm");
  EXPECT_EQ(extensions_text(kWritesMesh, " "), ".obj");
  EXPECT_EQ(extensions_text(kWritesSkin, " "), ".rig.txt .gltf .glb .vrm .fbx .usda .usdz");
  EXPECT_EQ(extensions_text(kWritesWithMesh, " "), ".obj .gltf .glb .vrm .fbx .usda .usdz");
  EXPECT_EQ(extensions_text(kReadsPicture), ".png, .jpg, .jpeg");
}

// Extensions, stems and neighbors by name alone.

TEST(FileKinds, WhatIsNotReadHasAWayOut) {
  EXPECT_NE(remedy("a/dance.pkl").find("numpy.savez('dance.npz', **numpy.load('a/dance.pkl', allow_pickle=True))"),
            std::string::npos);
  EXPECT_NE(remedy("07.asf").find("give the .amc beside it"), std::string::npos);
  EXPECT_EQ(remedy("x.unheard"), "");
}

TEST(FileNames, ExtensionsInAnyCaseBehindAName) {
  EXPECT_TRUE(has_extension("a/b.GLB", ".glb"));
  EXPECT_TRUE(has_extension("dog.rig.txt", ".rig.txt"));
  EXPECT_FALSE(has_extension("dog.txt", ".rig.txt"));
  EXPECT_FALSE(has_extension(".glb", ".glb"));
  EXPECT_FALSE(has_extension("", ".glb"));
}

TEST(FileNames, StemsNameCharacters) {
  EXPECT_EQ(stem_of("folder.d/dog.rig.txt"), "dog");
  EXPECT_EQ(stem_of("dog.v2.obj"), "dog.v2");
  EXPECT_EQ(stem_of("a/settings.json"), "settings");
  EXPECT_EQ(stem_of("-"), "stdin");
}

TEST(FileNames, TheRigLiesBesideTheMesh) {
  EXPECT_EQ(rig_path_beside("a/dog.obj"), "a/dog.rig.txt");
  EXPECT_EQ(rig_path_beside("dog.v2.OBJ"), "dog.v2.rig.txt");
}

}  // namespace
}  // namespace sinew
