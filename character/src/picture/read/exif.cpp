// SPDX-License-Identifier: MIT
// The one number of a camera's EXIF data that changes what a picture shows.
#include <cstring>

#include "picture/read/decoders.hpp"

namespace sinew::picture {
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
