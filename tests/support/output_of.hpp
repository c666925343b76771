// SPDX-License-Identifier: MIT
// What a command prints: for tests that look at object code and symbols with binutils.
#ifndef SINEW_TESTS_SUPPORT_OUTPUT_OF_HPP
#define SINEW_TESTS_SUPPORT_OUTPUT_OF_HPP

#include <array>
#include <cstdio>
#include <string>

namespace sinew_test {

// Standard output of a shell command; empty when it fails.
inline std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string out;
  std::array<char, 65536> block;
  for (size_t n; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;) out.append(block.data(), n);
  return pclose(pipe) == 0 ? out : std::string();
}

}  // namespace sinew_test
#endif
