# SPDX-License-Identifier: MIT
sinew_test(growing_structs_test SOURCES integration/growing_structs_test.cpp LIBS sinew::engine LABELS integration)
