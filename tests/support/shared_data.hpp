// SPDX-License-Identifier: MIT
// Where the data sets lie that are not part of the repository, if this machine has them.
#ifndef SINEW_TESTS_SHARED_DATA_HPP
#define SINEW_TESTS_SHARED_DATA_HPP

#include <cstdlib>
#include <filesystem>

// $SINEW_SHARED_DIR, or "shared" beside the repository; empty when there is none.
inline std::filesystem::path shared_folder() {
  const char* named = std::getenv("SINEW_SHARED_DIR");
  const std::filesystem::path folder =
      named ? std::filesystem::path(named) : std::filesystem::path(SINEW_SOURCE_DIR) / ".." / "shared";
  return std::filesystem::is_directory(folder / "data" / "characters") ? folder : std::filesystem::path();
}

#endif
