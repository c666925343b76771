// SPDX-License-Identifier: MIT
// A character of the C API that closes itself.
#ifndef SINEW_TESTS_SUPPORT_CHARACTER_HANDLE_HPP
#define SINEW_TESTS_SUPPORT_CHARACTER_HANDLE_HPP

#include <gtest/gtest.h>

#include <memory>
#include <string>

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

}  // namespace sinew
#endif
