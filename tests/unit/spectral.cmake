# SPDX-License-Identifier: MIT
sinew_test(sinew_spectral_test SOURCES unit/spectral_test.cpp LIBS sinew::engine_internals LABELS unit)
