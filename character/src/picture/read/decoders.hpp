// SPDX-License-Identifier: MIT
// Decoders, one per format.
#ifndef SINEW_CHARACTER_PICTURE_READ_DECODERS_HPP
#define SINEW_CHARACTER_PICTURE_READ_DECODERS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/picture/picture_file.hpp"

namespace sinew::picture {

// Rows as the file has them. Throw Error, which begins with `path`.
Pixels decode_png(const std::string& path, const std::vector<uint8_t>& bytes);
Pixels decode_jpeg(const std::string& path, const std::vector<uint8_t>& bytes);

// The tag 0x0112 of a JPEG's EXIF data (Exif 2.3, 4.6.4), 1 where there is none or it makes no sense.
uint8_t exif_orientation(const std::vector<uint8_t>& jpeg);

// As it is seen.
Pixels turned(Pixels pixels, uint8_t orientation);

// Throws Error for sides of 0 or above kMostPictureSide.
void check_sides(const std::string& path, uint64_t width, uint64_t height);

}  // namespace sinew::picture
#endif
