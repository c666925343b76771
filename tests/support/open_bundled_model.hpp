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

namespace sinew_test {

// A model file of samples/data, opened by `open`.
struct BundledModel {
  std::vector<uint64_t> bytes;  // 8-byte aligned
  sinew_model model = {};
  bool ok = false;

  template <class Open>
  BundledModel(const char* path, Open open) {
    std::FILE* file = std::fopen(path, "rb");
    if (file == nullptr) return;
    bytes.resize(512 * 1024);
    const size_t size = std::fread(bytes.data(), 1, bytes.size() * 8, file);
    std::fclose(file);
    ok = open(bytes.data(), size, &model) == SINEW_OK;
  }
};

}  // namespace sinew_test

inline const sinew_model* bundled_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew", sinew_model_open);
  EXPECT_TRUE(opened.ok) << "samples/data/sinew_default.sinew is missing or refused";
  return opened.ok ? &opened.model : nullptr;
}

inline const sinew_model* bundled_rig_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_rig.sinew", sinew_rig_model_open);
  EXPECT_TRUE(opened.ok) << "samples/data/sinew_rig.sinew is missing or refused";
  return opened.ok ? &opened.model : nullptr;
}

inline const sinew_model* bundled_hands_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_hands.sinew",
                                               sinew_rig_model_open);
  EXPECT_TRUE(opened.ok) << "samples/data/sinew_hands.sinew is missing or refused";
  return opened.ok ? &opened.model : nullptr;
}

#endif
