// SPDX-License-Identifier: MIT
// A character of the C API that closes itself, and files for it in memory.
#ifndef SINEW_TESTS_SUPPORT_CHARACTER_HANDLE_HPP
#define SINEW_TESTS_SUPPORT_CHARACTER_HANDLE_HPP

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "cli_fixture.hpp"
#include "sinew/character.h"

namespace sinew {

struct Close {
  void operator()(sinew_character* character) const { sinew_character_close(character); }
};
using Handle = std::unique_ptr<sinew_character, Close>;

inline Handle open(const std::string& path) {
  sinew_character* character = nullptr;
  EXPECT_EQ(sinew_character_open(path.c_str(), &character), SINEW_OK) << sinew_character_error(nullptr);
  return Handle(character);
}

// Files of the disk as files in memory, named without their folder.
class MemoryFiles {
 public:
  explicit MemoryFiles(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      bytes_.push_back(slurp(path));
      names_.push_back(fs::path(path).filename().string());
    }
    for (size_t i = 0; i < paths.size(); ++i) files_.push_back({names_[i].c_str(), bytes_[i].data(), bytes_[i].size()});
  }
  MemoryFiles(const MemoryFiles&) = delete;
  const sinew_file* data() const { return files_.data(); }
  uint32_t count() const { return static_cast<uint32_t>(files_.size()); }

 private:
  std::vector<std::string> bytes_, names_;
  std::vector<sinew_file> files_;
};

}  // namespace sinew
#endif
