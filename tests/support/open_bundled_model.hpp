// SPDX-License-Identifier: MIT
// The model that the command ships, opened once per test program.
#ifndef SINEW_TESTS_OPEN_BUNDLED_MODEL_HPP
#define SINEW_TESTS_OPEN_BUNDLED_MODEL_HPP

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "sinew/sinew.h"

inline const sinew_model* bundled_model() {
  struct Opened {
    std::vector<uint64_t> bytes;  // 8-byte aligned
    sinew_model model = {};
    bool ok = false;
    Opened() {
      std::FILE* file = std::fopen(SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew", "rb");
      if (file == nullptr) return;
      bytes.resize(512 * 1024);
      const size_t size = std::fread(bytes.data(), 1, bytes.size() * 8, file);
      std::fclose(file);
      ok = sinew_model_open(bytes.data(), size, &model) == SINEW_OK;
    }
  };
  static const Opened opened;
  EXPECT_TRUE(opened.ok) << "samples/data/sinew_default.sinew is missing or refused";
  return opened.ok ? &opened.model : nullptr;
}

#endif
