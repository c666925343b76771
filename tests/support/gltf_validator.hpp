// SPDX-License-Identifier: MIT
// Calls the Khronos glTF validator (npm package gltf-validator, pinned in tests/support/node) on files.
#ifndef SINEW_TESTS_GLTF_VALIDATOR_HPP
#define SINEW_TESTS_GLTF_VALIDATOR_HPP

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

struct ValidatorResult {
  int status = -1;  // 0 fine, 1 errors in a file, 2 the validator is missing
  std::string report;
};

// $SINEW_NODE_DIR, or tests/support/node, is where `npm ci` put it.
inline ValidatorResult validate_gltf(const std::vector<std::string>& files) {
  const char* folder = std::getenv("SINEW_NODE_DIR");
  std::string command = std::string("node '") + SINEW_SOURCE_DIR + "/tests/support/validate_gltf.mjs' '" +
                        (folder != nullptr ? folder : SINEW_SOURCE_DIR "/tests/support/node") + "'";
  for (const std::string& file : files) command.append(" '").append(file).append("'");
  command.append(" 2>&1");
  ValidatorResult result;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return result;
  char buffer[4096];
  for (size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.report.append(buffer, got);
  const int status = pclose(pipe);
  result.status = status >= 0 && status % 256 == 0 ? status / 256 : -1;
  return result;
}

// Only who says so may go without the validator.
inline bool validator_is_waived() { return std::getenv("SINEW_SKIP_GLTF_VALIDATOR") != nullptr; }

#define SINEW_EXPECT_VALID_GLTF(files)                                                                                \
  do {                                                                                                                \
    if (validator_is_waived())                                                                                        \
      GTEST_SKIP() << "SINEW_SKIP_GLTF_VALIDATOR is set: THE WRITTEN GLB FILES WERE NOT VALIDATED";                   \
    const ValidatorResult result = validate_gltf(files);                                                              \
    EXPECT_EQ(result.status, 0)                                                                                       \
        << result.report << "\n(install it: npm ci --prefix tests/support/node; or set SINEW_SKIP_GLTF_VALIDATOR=1)"; \
    EXPECT_EQ(result.report.find("warning "), std::string::npos) << result.report;                                    \
  } while (false)

#endif
