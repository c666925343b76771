// SPDX-License-Identifier: MIT
// PNG files of every kind become the same pixels; damaged ones a line.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "small_pictures.hpp"

#ifdef SINEW_HAS_PNG
namespace sinew::test {
namespace {

const std::vector<uint8_t> kTwo = {10, 20, 30, 200, 100, 50};  // a row of two pixels
const std::vector<uint8_t> kTwoSeen = {10, 20, 30, 255, 200, 100, 50, 255};

TEST(ReadPng, DepthsAndPalettesAreOnePicture) {
  EXPECT_EQ(decode_picture("a.png", png_bytes(2, 1, 8, 2, kTwo)).pixels.rgba, kTwoSeen);
  EXPECT_EQ(decode_picture("a.png", png_bytes(2, 1, 8, 3, {0, 1}, kTwo)).pixels.rgba, kTwoSeen);
  EXPECT_EQ(decode_picture("a.png", png_bytes(2, 1, 8, 6, {10, 20, 30, 255, 200, 100, 50, 255})).pixels.rgba, kTwoSeen);
  const std::vector<uint8_t> deep = {10, 10, 20, 20, 30, 30, 200, 200, 100, 100, 50, 50};
  EXPECT_EQ(decode_picture("a.png", png_bytes(2, 1, 16, 2, deep)).pixels.rgba, kTwoSeen);
  EXPECT_EQ(decode_picture("a.png", png_bytes(2, 1, 1, 0, {0x40})).pixels.rgba,
            (std::vector<uint8_t>{0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(ReadPng, AlphaIsKept) {
  EXPECT_EQ(decode_picture("a.png", png_bytes(1, 1, 8, 6, {9, 8, 7, 6})).pixels.rgba,
            (std::vector<uint8_t>{9, 8, 7, 6}));
}

TEST(ReadPng, EveryTruncationIsALine) {
  const std::vector<uint8_t> whole = png_bytes(2, 1, 8, 2, kTwo);
  for (size_t size = 0; size + 12 < whole.size(); ++size)
    EXPECT_ERROR(decode_picture("cut.png", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
                 "cut.png: ");
}

TEST(ReadPng, SidesAreLimited) {
  EXPECT_ERROR(decode_picture("wide.png", png_bytes(8193, 1, 8, 0, std::vector<uint8_t>(8193))),
               "wide.png: ", "8193 x 1", "8192");
  EXPECT_EQ(decode_picture("wide.png", png_bytes(8192, 1, 8, 0, std::vector<uint8_t>(8192))).pixels.width, 8192u);
}

TEST(ReadPng, OtherFilesAreNamed) {
  EXPECT_ERROR(decode_picture("a.png", {}), "a.png: ", "an empty file");
  EXPECT_ERROR(decode_picture("a.png", {'G', 'I', 'F', '8', '9', 'a'}), "a.png: ", "expected a PNG or JPEG");
}

}  // namespace
}  // namespace sinew::test
#endif
