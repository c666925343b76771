# SPDX-License-Identifier: MIT
if(SINEW_BUILD_FORMATS)
  sinew_test(synthesize_test SOURCES unit/synthesize_test.cpp LIBS sinew::formats LABELS unit)
endif()
