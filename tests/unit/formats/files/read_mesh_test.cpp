// SPDX-License-Identifier: MIT
// A mesh and its skeleton by the names of their files.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
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
  EXPECT_ERROR(read_mesh("cat.max"), "3ds Max");
  EXPECT_ERROR(read_character("cat.MB"), "Maya", "FBX");
  EXPECT_ERROR(read_mesh("cat.stl"), "Blender");
  Character c;
  EXPECT_ERROR(read_skeleton("cat.stl", false, &c), "expected a skeleton", "Blender");
  EXPECT_ERROR(read_mesh("cat.bvh"), "sinew animate --motion");
  EXPECT_ERROR(read_motion("cat.blend"), "expected a motion", "blender --background cat.blend");
}

TEST(ReadMesh, UsdIsWrittenAndNotRead) {
  const std::string remedy = "sinew writes USD but does not read it: export glTF or FBX";
  for (const std::string path : {"cat.usda", "cat.usdz", "cat.usdc", "cat.USD"}) {
    EXPECT_ERROR(read_mesh(path), path, "expected a mesh", remedy, "usd_import(filepath='" + path + "')");
    Character c;
    EXPECT_ERROR(read_skeleton(path, false, &c), path, "expected a skeleton", remedy);
    EXPECT_ERROR(read_character(path), path, "expected a character", remedy);
    EXPECT_ERROR(read_motion(path), path, "expected a motion", remedy);
  }
}

}  // namespace
}  // namespace sinew
