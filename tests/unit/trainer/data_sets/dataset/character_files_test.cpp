// SPDX-License-Identifier: MIT
// The files of a character belong together.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_data_sets/dedup.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

TEST(CharacterFiles, BelongTogetherAndAreNeverReplaced) {
  const TempFolder folder;
  const std::string data = std::string(SINEW_SOURCE_DIR) + "/samples/data/";
  folder.write("part one.bin", "1234");
  const std::string document =
      folder.write("c.gltf", R"({"buffers":[{"uri":"part%20one.bin"},{"uri":"data:,x"}],"images":[]})");
  place_character(document, folder.file("with_buffer"));
  EXPECT_EQ(read_file(folder.file("with_buffer/part one.bin")), (std::vector<uint8_t>{49, 50, 51, 52}));
  const std::string outside = folder.write("d.gltf", R"({"buffers":[{"uri":"../secret.bin"}]})");
  EXPECT_ERROR(place_character(outside, folder.file("without")), "outside");

  place_character(data + "snake__long.obj", folder.file("out"));
  EXPECT_EQ(read_file(folder.file("out/snake__long.rig.txt")), read_file(data + "snake__long.rig.txt"));
  EXPECT_ERROR(place_character(data + "snake__long.obj", folder.file("out")), "there already");
}

}  // namespace
}  // namespace sinew
