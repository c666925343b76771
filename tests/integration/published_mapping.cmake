# SPDX-License-Identifier: MIT
if(TARGET sinew_formats AND SINEW_PUBLISHED_METHODS)
  sinew_test(published_mapping_test SOURCES integration/published_mapping_test.cpp LIBS sinew::character LABELS integration)
endif()
