// SPDX-License-Identifier: MIT
// Frames: the picture again at rest, loops that decode frame by frame, sheets whose JSON says where frames lie.
#include "sinew_character/picture/sprites.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "expect_error.hpp"
#include "sinew_character/picture/figure.hpp"
#include "sinew_character/picture/picture_mesh.hpp"
#include "small_pictures.hpp"

namespace sinew::test {
namespace {

bool in_sprite(int x, int y) { return in_disc(x, y, 60, 50, 40) && !in_disc(x, y, 60, 50, 12); }
const Rgba kBlue = {20, 40, 220, 255};

PictureFile body() {
  return picture_of(120, 100, [](int x, int y) { return !in_sprite(x, y) ? kClear : x < 60 ? kRed : kBlue; });
}

Pixels drawn(const PictureFile& picture, float shift) {
  PictureMeshOptions options;
  options.pixels = true;
  Character mesh = picture_mesh(picture, find_figure(picture), options);
  for (Vec3& v : mesh.vertices) v.x += shift;
  return draw_in_plane(picture, mesh, {0, 100, 1, 120, 100});
}

TEST(Sprites, AtRestThePictureIsSeen) {
  const Pixels seen = drawn(body(), 0);
  ASSERT_EQ(seen.width, 120u);
  size_t wrong = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 120; ++x) {
      const uint8_t* p = &seen.rgba[static_cast<size_t>(y * 120 + x) * 4];
      const bool opaque = p[3] > 127;
      wrong += opaque != in_sprite(x, y) || (opaque && (p[0] > p[2]) != (x < 60)) ? 1 : 0;
    }
  EXPECT_LT(wrong, 120u) << "more than a rim of half a pixel";
  EXPECT_EQ(seen.rgba[(50 * 120 + 30) * 4 + 0], kRed[0]) << "no light is added";
  EXPECT_EQ(seen.rgba[(50 * 120 + 30) * 4 + 3], 255);
}

TEST(Sprites, WhatIsNearerCovers) {
  const PictureFile picture = body();
  Character card = picture_mesh(picture, find_figure(picture), {true, true});
  const size_t before = card.vertices.size();
  Character both = card;  // a second one before it, moved by 30 pixels
  for (const Vec3& v : card.vertices) both.vertices.push_back({v.x + 30, v.y, v.z + 9});
  for (const uint32_t v : card.face_vertices) both.face_vertices.push_back(v + static_cast<uint32_t>(before));
  both.corner_uvs.insert(both.corner_uvs.end(), card.corner_uvs.begin(), card.corner_uvs.end());
  for (size_t f = 1; f < card.face_offsets.size(); ++f)
    both.face_offsets.push_back(card.face_offsets[f] + static_cast<uint32_t>(card.face_vertices.size()));
  const Pixels seen = draw_in_plane(picture, both, {0, 100, 1, 160, 100});
  const auto red_at = [&](size_t x, size_t y) { return seen.rgba[(y * 160 + x) * 4] > 150; };
  EXPECT_TRUE(red_at(70, 20)) << "the nearer one's left half is on the other's right half";
  EXPECT_FALSE(red_at(110, 50));
}

uint32_t number_at(const std::vector<uint8_t>& bytes, size_t at) {
  return uint32_t{bytes[at]} << 24 | uint32_t{bytes[at + 1]} << 16 | uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
}

void put_chunk(const std::string& kind, const std::vector<uint8_t>& data, std::vector<uint8_t>* out) {
  std::vector<uint8_t> body(kind.begin(), kind.end());
  body.insert(body.end(), data.begin(), data.end());
  uint32_t crc = ~0u;
  for (const uint8_t byte : body) {
    crc ^= byte;
    for (int k = 0; k < 8; ++k) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
  }
  const auto put = [out](uint32_t v) {
    for (int shift = 24; shift >= 0; shift -= 8) out->push_back(static_cast<uint8_t>(v >> shift));
  };
  put(static_cast<uint32_t>(data.size()));
  out->insert(out->end(), body.begin(), body.end());
  put(~crc);
}

TEST(Sprites, ALoopHasEveryFrame) {
  const PictureFile picture = body();
  const std::vector<SpriteFrame> frames = {{"a 0", drawn(picture, 0), 40}, {"a 1", drawn(picture, 15), 60}};
  const std::vector<uint8_t> loop = encode_loop(frames);
  EXPECT_EQ(decode_picture("loop.png", loop).pixels.rgba, frames[0].pixels.rgba) << "a PNG of the first frame";
  // The second frame's data as a PNG of its own; chunks are counted through.
  std::vector<uint8_t> second(loop.begin(), loop.begin() + 8);
  std::string kinds;
  uint32_t next = 0;
  for (size_t at = 8; at < loop.size();) {
    const uint32_t size = number_at(loop, at);
    const std::string kind(loop.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                           loop.begin() + static_cast<std::ptrdiff_t>(at) + 8);
    const std::vector<uint8_t> data(loop.begin() + static_cast<std::ptrdiff_t>(at) + 8,
                                    loop.begin() + static_cast<std::ptrdiff_t>(at + 8 + size));
    if (kind == "fcTL" || kind == "fdAT") {
      EXPECT_EQ(number_at(data, 0), next++) << kind;
    }
    if (kind == "fcTL") {
      kinds += std::to_string(data[21]) + " ";  // milliseconds
    }
    if (kind == "acTL") {
      EXPECT_EQ(number_at(data, 0), 2u);
    }
    if (kind == "IHDR") put_chunk(kind, data, &second);
    if (kind == "fdAT") put_chunk("IDAT", {data.begin() + 4, data.end()}, &second);
    at += size + 12;
  }
  put_chunk("IEND", {}, &second);
  EXPECT_EQ(kinds, "40 60 ");
  EXPECT_EQ(decode_picture("second.png", second).pixels.rgba, frames[1].pixels.rgba);
}

TEST(Sprites, ASheetSaysWhereItsFramesLie) {
  const PictureFile picture = body();
  std::vector<SpriteFrame> frames;
  for (int f = 0; f < 5; ++f)
    frames.push_back(
        {(f < 3 ? "walk " : "wave ") + std::to_string(f % 3), drawn(picture, 3.0f * static_cast<float>(f)), 80});
  const SpriteSheet sheet = sprite_sheet(frames, "hero.png");
  EXPECT_EQ(sheet.pixels.width, 240u);
  EXPECT_EQ(sheet.pixels.height, 300u);
  const uint8_t* row = &sheet.pixels.rgba[(size_t{100 + 50} * 240 + 120) * 4];  // the fourth frame
  EXPECT_TRUE(std::equal(row, row + 120 * 4, &frames[3].pixels.rgba[size_t{50} * 120 * 4]));
  for (const char* part :
       {"\"wave 0\"", "\"image\": \"hero.png\"", "\"duration\": 80", "\"name\": \"walk\"", "\"to\": 4"})
    EXPECT_NE(sheet.json.find(part), std::string::npos) << part;
  EXPECT_ERROR(sprite_sheet({}, "hero.png"), "expected frames, found none");
  frames[1].pixels.width = 60;
  EXPECT_ERROR(encode_loop(frames), "frames of one size");
}

}  // namespace
}  // namespace sinew::test
