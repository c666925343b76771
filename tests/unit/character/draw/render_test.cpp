// SPDX-License-Identifier: MIT
// Pictures: PNG files decode to what was encoded, a cube covers what it should, colors tell joints apart.
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "sinew_character/draw/image.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using Color = std::array<uint8_t, 3>;

Image decode(const std::vector<uint8_t>& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  Image image;
  if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size())) return image;
  header.format = PNG_FORMAT_RGB;
  image.rgb.resize(PNG_IMAGE_SIZE(header));
  if (!png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr)) return image;
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  return image;
}

Color pixel(const Image& image, int x, int y) {
  const size_t at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

Character cube() {
  Character c;
  c.name = "cube";
  for (int v = 0; v < 8; ++v) c.vertices.push_back({v & 1 ? 1.0f : -1.0f, v & 2 ? 1.0f : -1.0f, v & 4 ? 1.0f : -1.0f});
  c.face_vertices = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  c.face_offsets = {0, 4, 8, 12, 16, 20, 24};
  return c;
}

RenderOptions from_the_front(int width, int height) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.yaw_degrees = options.pitch_degrees = 0;
  options.draw_skeleton = false;
  return options;
}

TEST(Png, DecodesToTheSamePixels) {
  Image image;
  image.width = 37;
  image.height = 11;
  for (size_t i = 0; i < 37 * 11 * 3; ++i) image.rgb.push_back(static_cast<uint8_t>(i * 89 % 251));
  const std::vector<uint8_t> bytes = encode_png(image);
  const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  ASSERT_GT(bytes.size(), 8u);
  EXPECT_EQ(std::memcmp(bytes.data(), signature, 8), 0);
  const Image back = decode(bytes);
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 11);
  EXPECT_EQ(back.rgb, image.rgb);
  image.rgb.pop_back();
  EXPECT_THROW(encode_png(image), Error);
  EXPECT_THROW(encode_png(Image{}), Error);
}

TEST(Images, StandSideBySide) {
  const Image red{1, 2, {255, 0, 0, 254, 0, 0}}, blue{2, 2, {0, 0, 255, 0, 0, 254, 0, 0, 253, 0, 0, 252}};
  const Image both = beside({red, blue});
  EXPECT_EQ(both.width, 3);
  EXPECT_EQ(both.height, 2);
  EXPECT_EQ(both.rgb, (std::vector<uint8_t>{255, 0, 0, 0, 0, 255, 0, 0, 254, 254, 0, 0, 0, 0, 253, 0, 0, 252}));
  EXPECT_THROW(beside({red, Image{1, 1, {0, 0, 0}}}), Error);
}

// Seen from the front a cube is a square that fills the picture up to the margin of 6 %, whatever the picture's shape.
TEST(Render, ACubeFromTheFrontIsASquare) {
  const Character c = cube();
  const Image image = render(c, std::vector<Color>(8, Color{220, 30, 30}), from_the_front(200, 100));
  const auto is_red = [](Color p) { return p[0] > 2 * p[1] && p[0] > 2 * p[2]; };
  int left = 200, right = -1, top = 100, bottom = -1, covered = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (!is_red(pixel(image, x, y))) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
      ++covered;
    }
  }
  EXPECT_NEAR(bottom - top + 1, 88, 2);
  EXPECT_NEAR(right - left + 1, 88, 2);
  EXPECT_NEAR((left + right) / 2.0, 99.5, 1);
  EXPECT_EQ(covered, (bottom - top + 1) * (right - left + 1)) << "holes in the face";
  EXPECT_FALSE(is_red(pixel(image, 5, 50)));
}

TEST(Render, ATriangleCoversHalfItsSquare) {
  Character c;
  c.name = "triangle";
  c.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  c.face_vertices = {0, 1, 2};
  c.face_offsets = {0, 3};
  const Image image = render(c, std::vector<Color>(3, Color{220, 30, 30}), from_the_front(100, 100));
  int covered = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) covered += pixel(image, x, y)[0] > 2 * pixel(image, x, y)[1];
  EXPECT_NEAR(covered, 88 * 88 / 2, 88);
}

// The nearer of two quads hides the other, whichever comes first in the file and whichever way it winds.
TEST(Render, NearerFacesHideFartherOnes) {
  for (const bool near_first : {false, true}) {
    Character c;
    c.name = "quads";
    c.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    c.face_vertices =
        near_first ? std::vector<uint32_t>{7, 6, 5, 4, 0, 1, 2, 3} : std::vector<uint32_t>{0, 1, 2, 3, 7, 6, 5, 4};
    c.face_offsets = {0, 4, 8};
    std::vector<Color> colors(8, Color{20, 20, 230});
    std::fill(colors.begin() + 4, colors.end(), Color{20, 230, 20});
    const Color middle = pixel(render(c, colors, from_the_front(64, 64)), 32, 32);
    EXPECT_GT(middle[1], 2 * middle[2]) << "near first: " << near_first;
  }
}

TEST(Render, ZUpStandsUpright) {
  Character c;
  c.name = "pole";  // long in z, red on top
  c.vertices = {{-0.1f, 0, 0}, {0.1f, 0, 0}, {0.1f, 0, 4}, {-0.1f, 0, 4}};
  c.face_vertices = {0, 1, 2, 3};
  c.face_offsets = {0, 4};
  RenderOptions options = from_the_front(64, 64);
  options.up = Axis::kZ;
  const Image image = render(c, {{20, 20, 230}, {20, 20, 230}, {230, 20, 20}, {230, 20, 20}}, options);
  const Color top = pixel(image, 32, 8), bottom = pixel(image, 32, 56);
  EXPECT_GT(top[0], top[2]);
  EXPECT_GT(bottom[2], bottom[0]);
}

TEST(Render, SkeletonIsDrawnOver) {
  Character c = cube();
  c.joints = {{"a", {0, -0.9f, 0}, -1}, {"b", {0, 0.9f, 0}, 0}, {"behind", {0, 0, 1000}, 1}};
  RenderOptions options = from_the_front(200, 200);
  const std::vector<Color> colors(8, Color{40, 40, 40});
  const Image without = render(c, colors, options);
  options.draw_skeleton = true;
  const Image with = render(c, colors, options);
  EXPECT_LT(pixel(without, 100, 100)[1], 120);
  EXPECT_GT(pixel(with, 100, 100)[1], pixel(without, 100, 100)[1] + 60) << "the bone's bright line";
  EXPECT_EQ(pixel(with, 30, 30), pixel(without, 30, 30));
}

TEST(Render, OddMeshesAndWrongSizes) {
  Character c = cube();
  EXPECT_THROW(render(c, {}, {}), Error);
  EXPECT_THROW(render(Character{}, {}, {}), Error);
  EXPECT_THROW(render(c, std::vector<Color>(8), from_the_front(0, 10)), Error);
  for (Vec3& v : c.vertices) v = {3, 3, 3};  // all in one point
  EXPECT_EQ(render(c, std::vector<Color>(8), from_the_front(16, 16)).rgb.size(), 16u * 16u * 3u);
  c.face_vertices.clear();
  c.face_offsets = {0, 0};  // a face without corners
  EXPECT_EQ(render(c, std::vector<Color>(8), from_the_front(16, 16)).rgb.size(), 16u * 16u * 3u);
}

TEST(Colors, NeighborsInTheListDiffer) {
  std::set<Color> seen;
  for (size_t j = 0; j < 300; ++j) {
    seen.insert(joint_color(j));
    for (size_t other = j > 8 ? j - 8 : 0; other < j; ++other) {
      const Color a = joint_color(j), b = joint_color(other);
      int difference = 0;
      for (size_t i = 0; i < 3; ++i) difference += std::abs(a[i] - b[i]);
      EXPECT_GT(difference, 40) << other << " and " << j;
    }
  }
  EXPECT_GT(seen.size(), 250u);
}

TEST(Colors, WeightsBlendAndErrorsRunFromBlueToRed) {
  Character c;
  c.joints = {{"a", {}, -1}, {"b", {}, 0}};
  c.vertices.resize(3);
  c.influences = {{{0, 1.0f}}, {{1, 0.25f}}, {}};
  const auto colors = weight_colors(c);
  EXPECT_EQ(colors[0], joint_color(0));
  EXPECT_EQ(colors[1], joint_color(1));
  EXPECT_EQ(colors[2], (Color{150, 150, 150}));
  const auto heat = heat_colors({0.0f, 1.0f, 2.0f, 9.0f}, 2.0f);
  EXPECT_GT(heat[0][2], heat[0][0]);
  EXPECT_GT(heat[1][0] + heat[1][1], 400);
  EXPECT_GT(heat[2][0], 5 * heat[2][2]);
  EXPECT_EQ(heat[2], heat[3]);
}

}  // namespace
}  // namespace sinew
