# SPDX-License-Identifier: MIT
sinew_test(sinew_heat_test SOURCES unit/heat_test.cpp LIBS sinew::engine_internals LABELS unit)
