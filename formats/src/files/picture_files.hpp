// SPDX-License-Identifier: MIT
// Pictures that materials name, found beside the file that names them.
#ifndef SINEW_FORMATS_FILES_PICTURE_FILES_HPP
#define SINEW_FORMATS_FILES_PICTURE_FILES_HPP

#include <map>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// "image/png" or "image/jpeg" by the first bytes: what glTF holds without extensions; nullptr for anything else.
const char* png_or_jpeg(const uint8_t* bytes, size_t size);

// One channel only: a height map, not a map of normals. PNG or JPEG.
bool is_gray(const std::vector<uint8_t>& picture);

class PictureFiles {
 public:
  // `owner` is the file that names pictures, relative to its folder. Remarks go into `notes`, once per picture.
  PictureFiles(std::string owner, std::vector<std::string>* notes) : owner_(std::move(owner)), notes_(notes) {}

  // The bytes of a PNG or JPEG; nullptr, with a note, when there is none of that name. Names come from other machines
  // too: backslashes part folders, and the picture may lie in the owner's folder itself.
  Picture find(const std::string& name);

 private:
  std::string owner_;
  std::vector<std::string>* notes_;
  std::map<std::string, Picture> known_;
};

}  // namespace sinew
#endif
