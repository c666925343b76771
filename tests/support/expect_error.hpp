// SPDX-License-Identifier: MIT
// EXPECT_ERROR(statement, "part", "part"...): it throws sinew::Error, one line that holds all the parts.
#ifndef SINEW_TESTS_EXPECT_ERROR_HPP
#define SINEW_TESTS_EXPECT_ERROR_HPP

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sinew_formats/error.hpp"

#define EXPECT_ERROR(statement, ...)                                                                         \
  do {                                                                                                       \
    std::string sinew_message;                                                                               \
    try {                                                                                                    \
      statement;                                                                                             \
      ADD_FAILURE() << #statement " did not throw";                                                          \
      break;                                                                                                 \
    } catch (const sinew::Error& error) {                                                                    \
      sinew_message = error.what();                                                                          \
    }                                                                                                        \
    for (const std::string& part : std::vector<std::string>{__VA_ARGS__})                                    \
      EXPECT_NE(sinew_message.find(part), std::string::npos) << "no '" << part << "' in: " << sinew_message; \
    EXPECT_EQ(sinew_message.find('\n'), std::string::npos) << sinew_message;                                 \
  } while (false)

#endif
