// SPDX-License-Identifier: MIT
// Extensions, stems and neighbours by name alone.
#include "sinew_formats/file_names.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

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
