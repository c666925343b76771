// SPDX-License-Identifier: MIT
// Compares affine transforms.
#ifndef SINEW_TESTS_SUPPORT_EXPECT_AFFINE_HPP
#define SINEW_TESTS_SUPPORT_EXPECT_AFFINE_HPP

#include <gtest/gtest.h>

#include "sinew_formats/base/affine.hpp"

namespace sinew_test {

inline void expect_affine(const sinew::Affine& found, const sinew::Affine& expected) {
  for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(found[i], expected[i], 1e-13) << "entry " << i;
}

}  // namespace sinew_test
#endif
