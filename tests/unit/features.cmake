# SPDX-License-Identifier: MIT
sinew_test(sinew_features_test SOURCES unit/features_test.cpp LIBS sinew::engine_internals LABELS unit)
