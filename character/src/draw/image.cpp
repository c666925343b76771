// SPDX-License-Identifier: MIT
// RGB images: PNG by libpng, pictures put side by side.
#include "sinew_character/draw/image.hpp"

#include <png.h>

#include "sinew_formats/error.hpp"

namespace sinew {

std::vector<uint8_t> encode_png(const Image& image) {
  const size_t expected = image.width > 0 && image.height > 0
                              ? static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 3
                              : 0;
  if (expected == 0 || image.rgb.size() != expected) {
    throw Error("PNG: an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) + " needs " +
                std::to_string(expected) + " bytes of RGB (more than none), found " + std::to_string(image.rgb.size()));
  }
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  // Room for the worst case at once: asking for the exact size would compress twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<uint8_t> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr)) {
    throw Error(std::string("PNG: the picture could not be compressed: ") + header.message);
  }
  bytes.resize(size);
  return bytes;
}

Image beside(const std::vector<Image>& images) {
  Image out;
  for (const Image& image : images) {
    if (image.height != images.front().height) {
      throw Error("pictures side by side need one height: found " + std::to_string(images.front().height) + " and " +
                  std::to_string(image.height));
    }
    out.width += image.width;
    out.height = image.height;
  }
  out.rgb.reserve(static_cast<size_t>(out.width) * static_cast<size_t>(out.height) * 3);
  for (int y = 0; y < out.height; ++y) {
    for (const Image& image : images) {
      const auto row = image.rgb.begin() + static_cast<std::ptrdiff_t>(y) * image.width * 3;
      out.rgb.insert(out.rgb.end(), row, row + static_cast<std::ptrdiff_t>(image.width) * 3);
    }
  }
  return out;
}

}  // namespace sinew
