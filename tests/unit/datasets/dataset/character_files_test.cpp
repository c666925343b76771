// SPDX-License-Identifier: MIT
// The files of a character belong together.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_datasets/dedup.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

TEST(CharacterFiles, BelongTogetherAndAreNeverReplaced) {
  const TempFolder folder;
  const std::string data = std::string(SINEW_SOURCE_DIR) + "/samples/data/";
  EXPECT_EQ(character_files("x/a.glb"), std::vector<std::string>{"x/a.glb"});
  EXPECT_EQ(character_files("x/a.obj"), (std::vector<std::string>{"x/a.obj", "x/a.rig.txt"}));
  folder.write("part one.bin", "1234");
  const std::string document =
      folder.write("c.gltf", R"({"buffers":[{"uri":"part%20one.bin"},{"uri":"data:,x"}],"images":[]})");
  EXPECT_EQ(character_files(document), (std::vector<std::string>{document, folder.file("part one.bin")}));
  const std::string outside = folder.write("d.gltf", R"({"buffers":[{"uri":"../secret.bin"}]})");
  EXPECT_ERROR(character_files(outside), "outside");

  place_character(data + "snake__long.obj", folder.file("out"));
  EXPECT_EQ(read_file(folder.file("out/snake__long.rig.txt")), read_file(data + "snake__long.rig.txt"));
  EXPECT_ERROR(place_character(data + "snake__long.obj", folder.file("out")), "there already");
}

}  // namespace
}  // namespace sinew
