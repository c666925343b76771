// SPDX-License-Identifier: MIT
// Chooses the decoder, checks limits, rotates rows by EXIF orientation.
#include <cstring>
#include <memory>
#include <utility>

#include "picture/read/decoders.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace picture {
namespace {

bool begins_with(const std::vector<uint8_t>& bytes, const char* text, size_t size) {
  return bytes.size() >= size && std::memcmp(bytes.data(), text, size) == 0;
}

// Index in the file's rows of a point of the displayed ones. Exif 2.3, figure 3: 2 mirrored, 3 180 degrees, 4 upside
// down, 5 to 8 with the axes exchanged.
template <typename T>
std::pair<T, T> file_row_point(uint8_t orientation, T x, T y, T last_x, T last_y) {
  switch (orientation) {
    case 2:
      return {last_x - x, y};
    case 3:
      return {last_x - x, last_y - y};
    case 4:
      return {x, last_y - y};
    case 5:
      return {y, x};
    case 6:
      return {y, last_x - x};
    case 7:
      return {last_y - y, last_x - x};
    case 8:
      return {last_y - y, x};
    default:
      return {x, y};
  }
}

}  // namespace

void check_sides(const std::string& path, uint64_t width, uint64_t height) {
  if (width >= 1 && height >= 1 && width <= kMostPictureSide && height <= kMostPictureSide) return;
  throw Error(path + ": expected a picture of 1 to " + std::to_string(kMostPictureSide) + " pixels per side, found " +
              std::to_string(width) + " x " + std::to_string(height) + "; make it smaller");
}

Pixels turned(Pixels pixels, uint8_t orientation) {
  if (orientation <= 1 || orientation > 8) return pixels;
  Pixels out;
  const bool exchanged = orientation >= 5;
  out.width = exchanged ? pixels.height : pixels.width;
  out.height = exchanged ? pixels.width : pixels.height;
  out.rgba.resize(pixels.rgba.size());
  for (uint32_t y = 0; y < out.height; ++y)
    for (uint32_t x = 0; x < out.width; ++x) {
      const auto from = file_row_point(orientation, x, y, out.width - 1, out.height - 1);
      std::memcpy(&out.rgba[(size_t{y} * out.width + x) * 4],
                  &pixels.rgba[(size_t{from.second} * pixels.width + from.first) * 4], 4);
    }
  return out;
}

}  // namespace picture

PictureFile decode_picture(const std::string& path, std::vector<uint8_t> bytes) {
  PictureFile out;
  out.name = stem_of(path);
  if (picture::begins_with(bytes, "\x89PNG\r\n\x1a\n", 8)) {
    out.pixels = picture::decode_png(path, bytes);
  } else if (picture::begins_with(bytes, "\xff\xd8\xff", 3)) {
    out.orientation = picture::exif_orientation(bytes);
    out.pixels = picture::turned(picture::decode_jpeg(path, bytes), out.orientation);
  } else {
    throw Error(path + ": expected a PNG or JPEG picture, found " +
                (bytes.empty() ? "an empty file" : "another format; convert it to PNG"));
  }
  out.bytes = std::make_shared<const std::vector<uint8_t>>(std::move(bytes));
  return out;
}

PictureFile read_picture(const std::string& path) { return decode_picture(path, read_file(path)); }

PicturePoint file_point(const PictureFile& picture, PicturePoint seen) {
  const auto point = picture::file_row_point(picture.orientation, seen.u, seen.v, 1.0f, 1.0f);
  return {point.first, point.second};
}

PicturePoint seen_point(const PictureFile& picture, PicturePoint in_file) {
  // Quarters undo each other, all others themselves.
  const uint8_t back = picture.orientation == 6 ? 8 : picture.orientation == 8 ? 6 : picture.orientation;
  const auto point = picture::file_row_point(back, in_file.u, in_file.v, 1.0f, 1.0f);
  return {point.first, point.second};
}

}  // namespace sinew

namespace sinew::picture {

// The one number of a camera's EXIF data that changes what a picture shows.

namespace {

// Reads within a TIFF block in either byte order; 0 beyond its end.
struct Tiff {
  const uint8_t* bytes;
  size_t size;
  bool little;
  uint32_t number(size_t at, size_t width) const {
    if (at > size || width > size - at) return 0;
    uint32_t value = 0;
    for (size_t i = 0; i < width; ++i) value = value << 8 | bytes[little ? at + width - 1 - i : at + i];
    return value;
  }
};

uint8_t orientation_of(const uint8_t* bytes, size_t size) {
  if (size < 8) return 1;
  const Tiff tiff = {bytes, size, bytes[0] == 'I'};
  const size_t first = tiff.number(4, 4);
  const uint32_t count = tiff.number(first, 2);
  for (uint32_t i = 0; i < count; ++i) {
    const size_t entry = first + 2 + size_t{12} * i;
    if (entry + 12 > size) break;
    if (tiff.number(entry, 2) != 0x0112) continue;
    const uint32_t value = tiff.number(entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<uint8_t>(value) : uint8_t{1};
  }
  return 1;
}

}  // namespace

uint8_t exif_orientation(const std::vector<uint8_t>& jpeg) {
  for (size_t at = 2; at + 4 <= jpeg.size() && jpeg[at] == 0xff;) {
    const uint8_t marker = jpeg[at + 1];
    const size_t length = size_t{jpeg[at + 2]} * 256 + jpeg[at + 3];
    if (marker == 0xda || length < 2 || at + 2 + length > jpeg.size()) break;
    if (marker == 0xe1 && length >= 8 && std::memcmp(&jpeg[at + 4], "Exif\0\0", 6) == 0)
      return orientation_of(&jpeg[at + 10], length - 8);
    at += 2 + length;
  }
  return 1;
}

}  // namespace sinew::picture
