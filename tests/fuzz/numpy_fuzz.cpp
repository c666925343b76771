// SPDX-License-Identifier: MIT
// Fuzz target: motions in NumPy files, arrays and zips of them.
#include "clip_checks.hpp"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const bool zip = size > 0 && data[0] == 'P';
  sinew::test::check_motion_file(sinew::test::input_file(data, size, zip ? "input.npz" : "input.npy"));
  return 0;
}
