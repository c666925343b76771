// SPDX-License-Identifier: MIT
// Frames as files: an animated PNG by libpng, and a sheet with a JSON of the frames' positions.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_character/picture/sprites.hpp"
#include "sinew_formats/error.hpp"

#ifdef SINEW_HAS_PNG
#include <png.h>
#endif

namespace sinew::picture {

inline void check_frames(const std::vector<SpriteFrame>& frames) {
  if (frames.empty()) throw Error("sprites: expected frames, found none");
  for (const SpriteFrame& frame : frames)
    if (frame.pixels.width != frames[0].pixels.width || frame.pixels.height != frames[0].pixels.height)
      throw Error("sprites: expected frames of one size");
}

}  // namespace sinew::picture

namespace sinew {

// Frames to PNG by libpng, and to an animated one out of the chunks of several.

namespace {

constexpr size_t kSignature = 8, kChunkFrame = 12;  // a chunk beside its data: length, kind, CRC

void put32(uint32_t value, std::vector<uint8_t>* out) {
  for (int shift = 24; shift >= 0; shift -= 8) out->push_back(static_cast<uint8_t>(value >> shift));
}
void put16(uint32_t value, std::vector<uint8_t>* out) {
  for (int shift = 8; shift >= 0; shift -= 8) out->push_back(static_cast<uint8_t>(value >> shift));
}

// PNG specification, annex D.
uint32_t crc_of(const uint8_t* bytes, size_t size) {
  static const std::array<uint32_t, 256> table = [] {
    std::array<uint32_t, 256> t{};
    for (uint32_t n = 0; n < 256; ++n) {
      uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = (c & 1) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      t[n] = c;
    }
    return t;
  }();
  uint32_t c = 0xffffffffu;
  for (size_t i = 0; i < size; ++i) c = table[(c ^ bytes[i]) & 255] ^ (c >> 8);
  return ~c;
}

void put_chunk(const char* kind, const std::vector<uint8_t>& data, std::vector<uint8_t>* out) {
  put32(static_cast<uint32_t>(data.size()), out);
  const size_t from = out->size();
  for (size_t i = 0; i < 4; ++i) out->push_back(static_cast<uint8_t>(kind[i]));
  out->insert(out->end(), data.begin(), data.end());
  put32(crc_of(out->data() + from, out->size() - from), out);
}

struct Chunk {
  std::string kind;
  std::vector<uint8_t> data;
};

// The chunks of a PNG that libpng has just written.
std::vector<Chunk> chunks_of(const std::vector<uint8_t>& png) {
  std::vector<Chunk> chunks;
  for (size_t at = kSignature; at + kChunkFrame <= png.size();) {
    const size_t size = size_t{png[at]} << 24 | size_t{png[at + 1]} << 16 | size_t{png[at + 2]} << 8 | png[at + 3];
    if (size > png.size() - at - kChunkFrame) break;
    const auto data = png.begin() + static_cast<std::ptrdiff_t>(at) + 8;
    chunks.push_back({std::string(data - 4, data), {data, data + static_cast<std::ptrdiff_t>(size)}});
    at += size + kChunkFrame;
  }
  return chunks;
}

// Frame control: the whole picture, shown for so long, instead of what was there.
std::vector<uint8_t> frame_control(uint32_t number, const SpriteFrame& frame) {
  std::vector<uint8_t> data;
  put32(number, &data);
  put32(frame.pixels.width, &data);
  put32(frame.pixels.height, &data);
  put32(0, &data);
  put32(0, &data);
  put16(std::min(frame.milliseconds, 65535u), &data);
  put16(1000, &data);
  data.push_back(1);  // cleared behind it
  data.push_back(0);  // not blended with it
  return data;
}

}  // namespace

#ifdef SINEW_HAS_PNG
std::vector<uint8_t> encode_png(const Pixels& pixels) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = pixels.width;
  header.height = pixels.height;
  header.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<uint8_t> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, pixels.rgba.data(), 0, nullptr))
    throw Error(std::string("PNG: the picture could not be compressed: ") + header.message);
  bytes.resize(size);
  return bytes;
}
#else
std::vector<uint8_t> encode_png(const Pixels&) {
  throw Error("PNG: this sinew was built without it; install libpng (Debian: libpng-dev) and build again");
}
#endif

std::vector<uint8_t> encode_loop(const std::vector<SpriteFrame>& frames) {
  picture::check_frames(frames);
  std::vector<uint8_t> out;
  uint32_t number = 0;
  for (size_t f = 0; f < frames.size(); ++f) {
    const std::vector<uint8_t> png = encode_png(frames[f].pixels);
    const std::vector<Chunk> chunks = chunks_of(png);
    if (f == 0) out.assign(png.begin(), png.begin() + kSignature);
    bool begun = false;
    for (const Chunk& chunk : chunks) {
      const bool is_data = chunk.kind == "IDAT";
      if (is_data && !begun) {
        if (f == 0) {
          std::vector<uint8_t> control;
          put32(static_cast<uint32_t>(frames.size()), &control);
          put32(0, &control);  // for ever
          put_chunk("acTL", control, &out);
        }
        put_chunk("fcTL", frame_control(number++, frames[f]), &out);
        begun = true;
      }
      if (f == 0 && chunk.kind != "IEND") put_chunk(chunk.kind.c_str(), chunk.data, &out);
      if (f == 0 || !is_data) continue;
      std::vector<uint8_t> data;
      put32(number++, &data);
      data.insert(data.end(), chunk.data.begin(), chunk.data.end());
      put_chunk("fdAT", data, &out);
    }
  }
  put_chunk("IEND", {}, &out);
  return out;
}

// Frames on one sheet, and a JSON of their positions.
SpriteSheet sprite_sheet(const std::vector<SpriteFrame>& frames, const std::string& image) {
  picture::check_frames(frames);
  const uint32_t w = frames[0].pixels.width, h = frames[0].pixels.height, count = static_cast<uint32_t>(frames.size());
  const auto square = static_cast<uint32_t>(std::lround(std::sqrt(static_cast<double>(count) * h / w)));
  const uint32_t columns = std::clamp(square, 1u, count), rows = (count + columns - 1) / columns;
  if (uint64_t{columns} * w > kMostPictureSide || uint64_t{rows} * h > kMostPictureSide)
    throw Error("sprites: " + std::to_string(count) + " frames of " + std::to_string(w) + " x " + std::to_string(h) +
                " pixels make a sheet of more than " + std::to_string(kMostPictureSide) + " per side; use fewer");
  SpriteSheet out;
  out.pixels.width = columns * w;
  out.pixels.height = rows * h;
  out.pixels.rgba.assign(size_t{out.pixels.width} * out.pixels.height * 4, 0);
  nlohmann::ordered_json json;
  for (uint32_t f = 0; f < count; ++f) {
    const uint32_t x = f % columns * w, y = f / columns * h;
    for (uint32_t row = 0; row < h; ++row)
      std::memcpy(&out.pixels.rgba[(size_t{y + row} * out.pixels.width + x) * 4],
                  &frames[f].pixels.rgba[size_t{row} * w * 4], size_t{w} * 4);
    json["frames"][frames[f].name] = {{"frame", {{"x", x}, {"y", y}, {"w", w}, {"h", h}}},
                                      {"rotated", false},
                                      {"trimmed", false},
                                      {"spriteSourceSize", {{"x", 0}, {"y", 0}, {"w", w}, {"h", h}}},
                                      {"sourceSize", {{"w", w}, {"h", h}}},
                                      {"duration", frames[f].milliseconds}};
  }
  // Frames of one clip are called alike but for the number behind the last space.
  const auto clip_of = [&](uint32_t f) { return frames[f].name.substr(0, frames[f].name.rfind(' ')); };
  nlohmann::ordered_json tags = nlohmann::ordered_json::array();
  for (uint32_t from = 0, to = 0; from < count; from = to + 1) {
    for (to = from; to + 1 < count && clip_of(to + 1) == clip_of(from);) ++to;
    tags.push_back({{"name", clip_of(from)}, {"from", from}, {"to", to}, {"direction", "forward"}});
  }
  json["meta"] = {{"app", "sinew"},
                  {"version", sinew_version()},
                  {"image", image},
                  {"format", "RGBA8888"},
                  {"size", {{"w", out.pixels.width}, {"h", out.pixels.height}}},
                  {"scale", "1"},
                  {"frameTags", std::move(tags)}};
  out.json = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  return out;
}

}  // namespace sinew
