// SPDX-License-Identifier: MIT
// What bindings ask when they load the library.
#include <gtest/gtest.h>

#include "sinew/abi.h"
#include "sinew/sinew.h"

namespace sinew {
namespace {

TEST(StructSizes, AreThoseOfTheCompiler) {
  EXPECT_EQ(sinew_struct_size("sinew_mesh"), sizeof(sinew_mesh));
  EXPECT_EQ(sinew_struct_size("sinew_skeleton"), sizeof(sinew_skeleton));
  EXPECT_EQ(sinew_struct_size("sinew_bind_options"), sizeof(sinew_bind_options));
  EXPECT_EQ(sinew_struct_size("sinew_transfer_outputs"), sizeof(sinew_transfer_outputs));
}

TEST(StructSizes, UnknownNamesAreZero) {
  EXPECT_EQ(sinew_struct_size(nullptr), 0u);
  EXPECT_EQ(sinew_struct_size(""), 0u);
  EXPECT_EQ(sinew_struct_size("sinew_mes"), 0u);
  EXPECT_EQ(sinew_struct_size("sinew_meshes"), 0u);
}

}  // namespace
}  // namespace sinew
