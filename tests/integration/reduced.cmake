# SPDX-License-Identifier: MIT
find_package(Threads REQUIRED)
sinew_test(reduced_bind_test
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/reduced_bind_test.cpp
  LIBS sinew::engine_internals Threads::Threads
  LABELS integration)
