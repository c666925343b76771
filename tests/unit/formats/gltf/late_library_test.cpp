// SPDX-License-Identifier: MIT
// Libraries that are loaded when a file needs them: called, or missed by one line.
#ifdef __linux__
#include "gltf/late_library.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"

namespace sinew {
namespace {

TEST(LateLibrary, CallsWhatIsThere) {
  const LateLibrary maths("libm.so.6", "the C library", "libc6");
  EXPECT_EQ(maths.call<double>("ldexp", 3.0, 4), 48.0);
}

TEST(LateLibrary, SaysWhatIsMissing) {
  const LateLibrary none("libsinew_none.so.9", "Nobody", "libnone-dev");
  EXPECT_ERROR(none.call<int>("cos"), "Nobody", "libsinew_none.so.9", "libnone-dev", ".glb");
  const LateLibrary maths("libm.so.6", "C library", "libc6");
  EXPECT_ERROR(maths.call<int>("no_such_function"), "libm.so.6", "no_such_function");
}

}  // namespace
}  // namespace sinew
#endif
