// SPDX-License-Identifier: MIT
// PNG and JPEG files as pixels.
#ifndef SINEW_CHARACTER_PICTURE_FILE_HPP
#define SINEW_CHARACTER_PICTURE_FILE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

constexpr uint32_t kMostPictureSide = 8192;

// A picture as displayed: oriented by its EXIF data, 8 bits per channel, alpha not premultiplied.
struct Pixels {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgba;  // [height x width x 4], row 0 on top; sRGB, alpha 255 if the file has none
};

struct PictureFile {
  std::string name;  // file stem
  Pixels pixels;
  Picture bytes;            // the file itself, for a texture
  uint8_t orientation = 1;  // of its EXIF data, 1..8: orientation of the file's rows relative to `pixels`
};

// PNG (any depth, palettes, interlaced) and JPEG (gray, YCbCr, RGB), recognized by their first bytes. Throws Error
// for another format, a damaged or truncated file, a side above kMostPictureSide, or a library that this build lacks.
PictureFile read_picture(const std::string& path);
// The same for bytes; `path` is for messages.
PictureFile decode_picture(const std::string& path, std::vector<uint8_t> bytes);

// Maps a point (u, v) of the displayed picture to the file's rows; all 0..1, v runs down.
struct PicturePoint {
  float u = 0, v = 0;
};
PicturePoint file_point(const PictureFile& picture, PicturePoint seen);
PicturePoint seen_point(const PictureFile& picture, PicturePoint in_file);

}  // namespace sinew
#endif
