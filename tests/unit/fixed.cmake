# SPDX-License-Identifier: MIT
sinew_test(fixed_test SOURCES ${CMAKE_CURRENT_LIST_DIR}/fixed_test.cpp LIBS sinew::engine_internals LABELS unit)
