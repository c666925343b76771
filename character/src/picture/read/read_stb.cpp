// SPDX-License-Identifier: MIT
// PNG and JPEG by stb_image, one header, where libpng and libjpeg are not: in WebAssembly (samples/npm/wasm/host.cmake). PNG gives libpng's pixels but for
// files with a gamma of their own; JPEG those of another decoder, off by a few steps of 255.
#include "picture/read/decoders.hpp"
#include "sinew_formats/error.hpp"

#ifdef SINEW_PICTURES_BY_STB
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <stb_image.h>
#pragma clang diagnostic pop

namespace sinew::picture {
namespace {

Pixels decode(const std::string& path, const char* what, const std::vector<uint8_t>& bytes) {
  const auto size = static_cast<int>(bytes.size());
  const auto refuse = [&] {
    return Error(path + ": cannot read this " + what + ": " + stbi_failure_reason() + "; save it again");
  };
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) throw refuse();
  check_sides(path, static_cast<uint64_t>(width), static_cast<uint64_t>(height));
  const std::unique_ptr<uint8_t, void (*)(void*)> rgba(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
  if (!rgba) throw refuse();
  Pixels pixels;
  pixels.width = static_cast<uint32_t>(width);
  pixels.height = static_cast<uint32_t>(height);
  pixels.rgba.assign(rgba.get(), rgba.get() + size_t{4} * pixels.width * pixels.height);
  return pixels;
}

}  // namespace

Pixels decode_png(const std::string& path, const std::vector<uint8_t>& bytes) { return decode(path, "PNG", bytes); }
Pixels decode_jpeg(const std::string& path, const std::vector<uint8_t>& bytes) { return decode(path, "JPEG", bytes); }

}  // namespace sinew::picture
#endif
