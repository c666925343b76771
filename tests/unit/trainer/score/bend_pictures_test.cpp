// SPDX-License-Identifier: MIT
// The report's pictures of bends: a panel for every joint that its name tells; of cloth a row of four for every bend under it, the same
// bytes again, and fewer crossings than before.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "sinew_formats/io.hpp"
#include "sinew_trainer/report.hpp"

namespace sinew {
namespace {

TEST(BendPictures, AHumanHasFive) {
  const Character biped = read_character(std::string(SINEW_SOURCE_DIR) + "/samples/data/biped__robed.obj");
  const ReportPicture picture = bend_pictures(biped, Axis::kY, 64);
  ASSERT_EQ(picture.panels.size(), 5u);
  for (const ReportPicture::Panel& panel : picture.panels) EXPECT_GT(panel.png.size(), 500u);
  EXPECT_NE(picture.panels[0].caption.find("elbow"), std::string::npos);
}

TEST(BendPictures, ASnakeHasNone) {
  const Character snake = read_character(std::string(SINEW_SOURCE_DIR) + "/samples/data/snake__long.obj");
  EXPECT_TRUE(bend_pictures(snake, Axis::kY, 64).panels.empty());
}

Character sample(const char* file) { return read_character(std::string(SINEW_SOURCE_DIR) + "/samples/data/" + file); }

size_t crossings_in(const std::string& caption) {
  return std::strtoul(caption.c_str() + caption.rfind(", ") + 2, nullptr, 10);
}

TEST(GarmentPictures, AShirtBeforeAndAfter) {
  const Character caped = sample("biped__caped.gltf");
  const Clothing clothing = measure_clothing(caped);
  ASSERT_EQ(clothing.bends, 1u);
  const ReportPicture picture = garment_pictures(caped, nullptr, Axis::kY, 64);
  ASSERT_EQ(picture.panels.size(), 4u);
  EXPECT_EQ(picture.columns, 4);
  const char* const what[] = {"bound alone", "nearest point", "--garment", "volume"};
  for (size_t p = 0; p < 4; ++p) {
    EXPECT_GT(picture.panels[p].png.size(), 500u);
    EXPECT_EQ(picture.panels[p].caption.find("shoulder, arm rotated by 75 degrees: "), 0u) << picture.panels[p].caption;
    EXPECT_NE(picture.panels[p].caption.find(what[p]), std::string::npos) << picture.panels[p].caption;
  }
  const size_t alone = crossings_in(picture.panels[0].caption);
  EXPECT_GT(alone, 20u) << "or this test could not fail";
  EXPECT_LT(crossings_in(picture.panels[2].caption), alone);
  EXPECT_LT(crossings_in(picture.panels[3].caption), alone);
  const ReportPicture again = garment_pictures(caped, nullptr, Axis::kY, 64);
  for (size_t p = 0; p < 4; ++p) {
    EXPECT_EQ(again.panels[p].png, picture.panels[p].png);
    EXPECT_EQ(again.panels[p].caption, picture.panels[p].caption);
  }
}

TEST(GarmentPictures, NoneOfTheUndressed) {
  for (const char* file : {"biped__robot.obj", "snake__long.obj"}) {
    EXPECT_EQ(measure_clothing(sample(file)).bends, 0u) << file;
    EXPECT_TRUE(garment_pictures(sample(file), nullptr, Axis::kY, 64).panels.empty()) << file;
  }
}

}  // namespace
}  // namespace sinew
