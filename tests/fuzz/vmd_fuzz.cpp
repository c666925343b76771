// SPDX-License-Identifier: MIT
// Fuzz target: motions of MikuMikuDance.
#include "clip_checks.hpp"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  sinew::test::check_motion_file(sinew::test::input_file(data, size, "input.vmd"));
  return 0;
}
