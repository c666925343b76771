# SPDX-License-Identifier: MIT
sinew_test(sinew_reduce_test SOURCES unit/reduction_test.cpp LIBS sinew::engine_internals LABELS unit)
