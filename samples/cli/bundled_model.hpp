// SPDX-License-Identifier: MIT
// The model file that the build puts into the program (generated bundled_model.cpp); size 0 when the build had none.
#ifndef SINEW_CLI_BUNDLED_MODEL_HPP
#define SINEW_CLI_BUNDLED_MODEL_HPP

#include <cstddef>
#include <cstdint>

namespace sinew::cli {

extern const uint8_t kBundledModel[];  // 8-byte aligned
extern const size_t kBundledModelSize;

}  // namespace sinew::cli
#endif
