// SPDX-License-Identifier: MIT
// PNG by libpng's simplified interface, which converts palettes, 16 bits, gray and interlaced rows into RGBA and
// never leaves by longjmp.
#include "picture/read/decoders.hpp"
#include "sinew_formats/error.hpp"

#ifdef SINEW_HAS_PNG
#include <png.h>
#endif

namespace sinew::picture {

#ifdef SINEW_HAS_PNG
Pixels decode_png(const std::string& path, const std::vector<uint8_t>& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()))
    throw Error(path + ": cannot read this PNG: " + header.message + "; save it again");
  struct Free {
    png_image* image;
    ~Free() { png_image_free(image); }
  } const free_header{&header};
  check_sides(path, header.width, header.height);
  header.format = PNG_FORMAT_RGBA;
  header.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // as every editor writes them
  Pixels pixels;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.rgba.resize(size_t{header.width} * header.height * 4);
  if (!png_image_finish_read(&header, nullptr, pixels.rgba.data(), 0, nullptr))
    throw Error(path + ": cannot read this PNG: " + header.message + "; save it again");
  return pixels;
}
#elif !defined(SINEW_PICTURES_BY_STB)
Pixels decode_png(const std::string& path, const std::vector<uint8_t>&) {
  throw Error(
      path + ": this sinew was built without PNG; install libpng (Debian: libpng-dev) and build again, or give a JPEG");
}
#endif

}  // namespace sinew::picture
