// SPDX-License-Identifier: MIT
// A mesh and its skeleton by the names of their files.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

TEST(ReadCharacter, WithoutItsRigIsAnError) {
  const TempFolder folder;
  EXPECT_ERROR(read_character(folder.write("cat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), "cat.rig.txt",
               "no such file");
}

TEST(ReadMesh, FilesOfOtherProgramsAreShownTheWayOut) {
  EXPECT_ERROR(read_mesh("art/cat.blend"), "art/cat.blend", "blender --background art/cat.blend", "filepath='cat.glb'");
  EXPECT_ERROR(read_mesh("cat.usdc"), "usdcat --flatten", "usd_import(filepath='cat.usdc')");
  EXPECT_ERROR(read_mesh("cat.max"), "3ds Max");
  EXPECT_ERROR(read_character("cat.MB"), "Maya", "FBX");
  EXPECT_ERROR(read_mesh("cat.stl"), "Blender");
  Character c;
  EXPECT_ERROR(read_skeleton("cat.stl", false, &c), "expected a skeleton", "Blender");
  EXPECT_ERROR(read_mesh("cat.bvh"), "sinew animate --motion");
}

}  // namespace
}  // namespace sinew
