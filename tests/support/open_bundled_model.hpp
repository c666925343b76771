// SPDX-License-Identifier: MIT
// The models that the command ships, opened once per test program.
#ifndef SINEW_TESTS_OPEN_BUNDLED_MODEL_HPP
#define SINEW_TESTS_OPEN_BUNDLED_MODEL_HPP

#include <gtest/gtest.h>

#include "bundled_model.hpp"

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

inline const sinew_model* bundled_front_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_front.sinew",
                                               sinew_rig_model_open);
  EXPECT_TRUE(opened.ok) << "samples/data/sinew_front.sinew is missing or refused";
  return opened.ok ? &opened.model : nullptr;
}

inline const sinew_model* bundled_hands_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_hands.sinew",
                                               sinew_rig_model_open);
  EXPECT_TRUE(opened.ok) << "samples/data/sinew_hands.sinew is missing or refused";
  return opened.ok ? &opened.model : nullptr;
}

#endif
