// SPDX-License-Identifier: MIT
// The corpus of one fuzz target as an ordinary test, with the compiler and flags of the build: every file, every
// truncation of it, and a few hundred single changed bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "fuzz.hpp"
#include "sinew_formats/io.hpp"

namespace {

std::vector<std::string> corpus_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(SINEW_FUZZ_CORPUS))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

// Every input is its own allocation, so that a sanitizer sees a read behind its end.
void run(const std::vector<uint8_t>& bytes) {
  const std::vector<uint8_t> exact(bytes);
  ASSERT_NO_THROW(LLVMFuzzerTestOneInput(exact.data(), exact.size()));
}

TEST(SINEW_FUZZ_SUITE, CorpusHoldsItsProperties) {
  const std::vector<std::string> files = corpus_files();
  ASSERT_GE(files.size(), 3u) << SINEW_FUZZ_CORPUS;
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    run(sinew::read_file(file));
    if (HasFatalFailure()) return;
  }
}

TEST(SINEW_FUZZ_SUITE, TruncatedAndChangedCorpusHoldsItsProperties) {
  constexpr size_t kMost = SINEW_FUZZ_CHANGES;  // per file, so that slow targets stay quick
  for (const std::string& file : corpus_files()) {
    const std::vector<uint8_t> whole = sinew::read_file(file);
    const size_t bits = whole.size() * 8, cuts = std::min(whole.size(), kMost), flips = std::min(bits, kMost);
    for (size_t i = 0; i < cuts; ++i) {
      const size_t length = i * whole.size() / cuts;
      SCOPED_TRACE(file + " cut to " + std::to_string(length));
      run({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
      if (HasFatalFailure()) return;
    }
    for (size_t i = 0; i < flips; ++i) {
      const size_t bit = i * bits / flips;
      SCOPED_TRACE(file + " with bit " + std::to_string(bit) + " changed");
      std::vector<uint8_t> changed = whole;
      changed[bit / 8] = static_cast<uint8_t>(changed[bit / 8] ^ (1u << bit % 8));
      run(changed);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
