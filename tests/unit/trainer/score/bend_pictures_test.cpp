// SPDX-License-Identifier: MIT
// The report's pictures of bends: a panel for every joint that its name tells.
#include "sinew_trainer/bend_pictures.hpp"

#include <gtest/gtest.h>

#include "sinew_formats/io.hpp"

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

}  // namespace
}  // namespace sinew
