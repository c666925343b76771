// SPDX-License-Identifier: MIT
// Frames on one sheet, and the JSON that says where each lies.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "picture/sprites/check_frames.hpp"
#include "sinew/sinew.h"
#include "sinew_character/picture/sprites.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

SpriteSheet sprite_sheet(const std::vector<SpriteFrame>& frames, const std::string& image) {
  picture::check_frames(frames);
  const uint32_t w = frames[0].pixels.width, h = frames[0].pixels.height, count = static_cast<uint32_t>(frames.size());
  const auto square = static_cast<uint32_t>(std::lround(std::sqrt(static_cast<double>(count) * h / w)));
  const uint32_t columns = std::clamp(square, 1u, count), rows = (count + columns - 1) / columns;
  if (uint64_t{columns} * w > kMostPictureSide || uint64_t{rows} * h > kMostPictureSide)
    throw Error("sprites: " + std::to_string(count) + " frames of " + std::to_string(w) + " x " + std::to_string(h) +
                " pixels make a sheet of more than " + std::to_string(kMostPictureSide) + " a side; take fewer");
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
