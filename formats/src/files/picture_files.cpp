// SPDX-License-Identifier: MIT
#include "files/picture_files.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"
#include "text/text_lines.hpp"

namespace fs = std::filesystem;

namespace sinew {

const char* png_or_jpeg(const uint8_t* bytes, size_t size) {
  if (size >= 8 && std::memcmp(bytes, "\x89PNG\r\n\x1a\n", 8) == 0) return "image/png";
  if (size >= 3 && std::memcmp(bytes, "\xff\xd8\xff", 3) == 0) return "image/jpeg";
  return nullptr;
}

bool is_gray(const std::vector<uint8_t>& picture) {
  if (picture.size() > 25 && picture[0] == 0x89) return picture[25] == 0 || picture[25] == 4;  // color type of IHDR
  // JPEG: segments up to the start of frame, whose tenth byte is the number of components.
  for (size_t at = 2; at + 9 < picture.size() && picture[at] == 0xff;) {
    const uint8_t marker = picture[at + 1];
    const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) return picture[at + 9] == 1;
    at += 2 + size_t{picture[at + 2]} * 256 + picture[at + 3];
  }
  return false;
}

Picture PictureFiles::find(const std::string& name) {
  const auto [at, is_new] = known_.try_emplace(name, nullptr);
  if (!is_new) return at->second;
  std::string plain = name;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  const fs::path folder = fs::path(owner_).parent_path();
  const std::string title = fs::path(owner_).filename().string();
  const std::string shown = in_quotes(fs::path(plain).filename().string());
  for (const fs::path& path : {folder / plain, folder / fs::path(plain).filename()}) {
    if (!is_file(path.string())) continue;
    try {
      auto bytes = std::make_shared<std::vector<uint8_t>>(read_file(path.string()));
      if (png_or_jpeg(bytes->data(), bytes->size()) == nullptr) {
        notes_->push_back(title + ": picture " + shown + " is not a PNG or JPEG, so the output lacks it; convert it");
        return nullptr;
      }
      return at->second = std::move(bytes);
    } catch (const Error&) {
      break;  // reported as missing
    }
  }
  notes_->push_back(title + ": picture " + shown + " was not found, so the output lacks it; put it beside the file");
  return nullptr;
}

}  // namespace sinew
