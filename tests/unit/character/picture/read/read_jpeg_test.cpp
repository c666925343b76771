// SPDX-License-Identifier: MIT
// JPEG files, turned as their EXIF data say.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "expect_error.hpp"
#include "picture/read/decoders.hpp"
#include "small_pictures.hpp"

#ifdef SINEW_HAS_JPEG
#include <jpeglib.h>

namespace sinew::test {
namespace {

// 16 x 8, red on the left, blue on the right.
std::vector<uint8_t> jpeg_bytes(int components) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = 16;
  info.image_height = 8;
  info.input_components = components;
  info.in_color_space = components == 1 ? JCS_GRAYSCALE : components == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 95, TRUE);
  jpeg_start_compress(&info, TRUE);
  std::vector<uint8_t> row;
  for (int x = 0; x < 16; ++x)
    for (int c = 0; c < components; ++c) row.push_back(c == (x < 8 ? 0 : 2) ? 255 : 0);
  uint8_t* rows[1] = {row.data()};
  for (int y = 0; y < 8; ++y) jpeg_write_scanlines(&info, rows, 1);
  jpeg_finish_compress(&info);
  std::vector<uint8_t> out(bytes, bytes + size);
  jpeg_destroy_compress(&info);
  std::free(bytes);
  return out;
}

std::vector<uint8_t> with_orientation(uint8_t orientation) {
  std::vector<uint8_t> out = jpeg_bytes(3);
  const std::vector<uint8_t> exif = {0xff, 0xe1, 0, 34, 'E', 'x',         'i', 'f', 0,    0,    'M', 'M',
                                     0,    42,   0, 0,  0,   8,           0,   1,   0x01, 0x12, 0,   3,
                                     0,    0,    0, 1,  0,   orientation, 0,   0,   0,    0,    0,   0};
  out.insert(out.begin() + 2, exif.begin(), exif.end());
  return out;
}

bool is_red(const Pixels& pixels, uint32_t x, uint32_t y) {
  const uint8_t* p = &pixels.rgba[(size_t{y} * pixels.width + x) * 4];
  return p[0] > 180 && p[2] < 80 && p[3] == 255;
}

TEST(ReadJpeg, ColorsAndGray) {
  const Pixels pixels = decode_picture("a.jpg", jpeg_bytes(3)).pixels;
  EXPECT_EQ(pixels.width, 16u);
  EXPECT_TRUE(is_red(pixels, 1, 1));
  EXPECT_FALSE(is_red(pixels, 14, 1));
  const Pixels gray = decode_picture("a.jpg", jpeg_bytes(1)).pixels;
  EXPECT_EQ(gray.rgba[0], gray.rgba[2]);
  EXPECT_ERROR(decode_picture("a.jpg", jpeg_bytes(4)), "a.jpg: ", "CMYK");
}

// Where the left side of the file is seen: to the left, right, right, left, top, top, bottom, bottom (Exif 2.3, figure 3).
TEST(ReadJpeg, ExifTurns) {
  for (uint8_t o = 1; o <= 8; ++o) {
    const PictureFile picture = decode_picture("a.jpg", with_orientation(o));
    EXPECT_EQ(picture.orientation, o);
    const bool turned = o >= 5;
    EXPECT_EQ(picture.pixels.width, turned ? 8u : 16u);
    const uint32_t last = 14;
    const bool red_first = o == 1 || o == 4 || o == 5 || o == 6;
    EXPECT_EQ(is_red(picture.pixels, turned ? 1 : 1, 1), red_first) << int{o};
    EXPECT_EQ(is_red(picture.pixels, turned ? 1 : last, turned ? last : 1), !red_first) << int{o};
    const PicturePoint in_file = file_point(picture, {0.25f, 0.125f}), back = seen_point(picture, in_file);
    EXPECT_FLOAT_EQ(back.u, 0.25f);
    EXPECT_FLOAT_EQ(back.v, 0.125f);
  }
  EXPECT_EQ(decode_picture("a.jpg", with_orientation(77)).orientation, 1);
}

TEST(ReadJpeg, CutOffIsALine) {
  const std::vector<uint8_t> whole = jpeg_bytes(3);
  for (size_t size = 3; size + 2 < whole.size(); ++size)
    EXPECT_ERROR(decode_picture("cut.jpg", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
                 "cut.jpg: ");
}

}  // namespace
}  // namespace sinew::test
#endif
