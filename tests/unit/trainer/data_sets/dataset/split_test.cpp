// SPDX-License-Identifier: MIT
// Training and validation, units kept together. The files of a character belong together.
#include "sinew_data_sets/split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

TEST(Split, KeepsUnitsTogetherAndComesAsCloseAsTheyAllow) {
  std::vector<std::string> keys;
  for (const auto& [family, count] : std::vector<std::pair<std::string, int>>{{"a", 50}, {"b", 7}, {"c", 5}, {"d", 3}})
    keys.insert(keys.end(), static_cast<size_t>(count), family);
  const std::vector<SplitUnit> units = split_units(keys);
  ASSERT_EQ(units.size(), 4u);
  std::set<std::vector<bool>> drawn;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<bool> chosen = choose_validation(units, 8.0 / 65, seed);
    EXPECT_EQ(chosen, choose_validation(units, 8.0 / 65, seed));
    size_t count = 0;
    for (size_t u = 0; u < units.size(); ++u) count += chosen[u] ? units[u].members.size() : 0;
    EXPECT_EQ(count, 8u) << "c and d; no other units come as close";
    drawn.insert(choose_validation(units, 0.1, seed));
  }
  for (const double share : {0.0, 1.0}) {
    const std::vector<bool> chosen = choose_validation(units, share, 1);
    const auto count = std::count(chosen.begin(), chosen.end(), true);
    EXPECT_GT(count, 0);
    EXPECT_LT(count, 4);
  }
  const std::vector<SplitUnit> singles = split_units({"p", "q", "r", "s", "t", "u"});
  for (uint64_t seed = 0; seed < 20; ++seed) drawn.insert(choose_validation(singles, 0.34, seed));
  EXPECT_GT(drawn.size(), 5u) << "other seeds, other choices";
  EXPECT_ERROR((choose_validation(split_units({"a", "a"}), 0.5, 1)), "at least two");
}

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
  EXPECT_ERROR(place_character(data + "snake__long.obj", folder.file("out")), "never replaced");
}

}  // namespace
}  // namespace sinew
