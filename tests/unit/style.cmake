# SPDX-License-Identifier: MIT
sinew_test(style_test SOURCES unit/style_test.cpp LIBS sinew::engine_internals LABELS unit)
