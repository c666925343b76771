# SPDX-License-Identifier: MIT
sinew_test(kernels_bind_test
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/kernels_bind_test.cpp
  LIBS sinew::engine_internals
  LABELS integration)
