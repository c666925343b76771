// SPDX-License-Identifier: MIT
// A model file of samples/data, opened; for test programs of every kind.
#ifndef SINEW_TESTS_BUNDLED_MODEL_HPP
#define SINEW_TESTS_BUNDLED_MODEL_HPP

#include <cstdint>
#include <cstdio>
#include <vector>

#include "sinew/sinew.h"

namespace sinew_test {

struct BundledModel {
  std::vector<uint64_t> bytes;  // 8-byte aligned
  sinew_model model = {};
  bool ok = false;

  // `open` is sinew_model_open or its like.
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
#endif
