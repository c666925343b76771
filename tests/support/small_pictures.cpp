// SPDX-License-Identifier: MIT
#include "small_pictures.hpp"

#include <algorithm>
#include <cstddef>

namespace sinew::test {
namespace {

void put(std::vector<uint8_t>* out, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out->push_back(static_cast<uint8_t>(value >> shift));
}

void put_chunk(std::vector<uint8_t>* out, const std::string& kind, const std::vector<uint8_t>& data) {
  put(out, static_cast<uint32_t>(data.size()));
  uint32_t crc = 0xffffffffu;
  const auto add = [&](uint8_t byte) {
    out->push_back(byte);
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
  };
  for (const char c : kind) add(static_cast<uint8_t>(c));
  for (const uint8_t byte : data) add(byte);
  put(out, crc ^ 0xffffffffu);
}

}  // namespace

std::vector<uint8_t> png_bytes(uint32_t width, uint32_t height, int depth, int color_type,
                               const std::vector<uint8_t>& rows, const std::vector<uint8_t>& palette) {
  std::vector<uint8_t> out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header, packed = {0x78, 0x01};
  put(&header, width);
  put(&header, height);
  header.insert(header.end(), {static_cast<uint8_t>(depth), static_cast<uint8_t>(color_type), 0, 0, 0});
  put_chunk(&out, "IHDR", header);
  if (!palette.empty()) put_chunk(&out, "PLTE", palette);
  const size_t row = height > 0 ? rows.size() / height : 0;
  std::vector<uint8_t> raw;
  for (size_t y = 0; y < height; ++y) {
    raw.push_back(0);
    raw.insert(raw.end(), rows.begin() + static_cast<std::ptrdiff_t>(y * row),
               rows.begin() + static_cast<std::ptrdiff_t>((y + 1) * row));
  }
  uint32_t a = 1, b = 0;
  for (size_t at = 0; at < raw.size() || at == 0; at += 65535) {
    const auto count = static_cast<uint32_t>(std::min<size_t>(65535, raw.size() - at));
    packed.push_back(at + count == raw.size() ? 1 : 0);
    for (const uint32_t n : {count, ~count})
      packed.push_back(static_cast<uint8_t>(n)), packed.push_back(static_cast<uint8_t>(n >> 8));
    packed.insert(packed.end(), raw.begin() + static_cast<std::ptrdiff_t>(at),
                  raw.begin() + static_cast<std::ptrdiff_t>(at + count));
  }
  for (const uint8_t byte : raw) a = (a + byte) % 65521, b = (b + a) % 65521;
  put(&packed, b << 16 | a);
  put_chunk(&out, "IDAT", packed);
  put_chunk(&out, "IEND", {});
  return out;
}

}  // namespace sinew::test
