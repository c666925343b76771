# SPDX-License-Identifier: MIT
sinew_test(cpp_wrapper_test SOURCES unit/cpp_wrapper_test.cpp LIBS sinew::engine_internals LABELS unit)
