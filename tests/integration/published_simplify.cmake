# SPDX-License-Identifier: MIT
# What simplification of skeletons promises, on the samples.
if(TARGET sinew::character)
  sinew_test(published_simplify_test SOURCES integration/published_simplify_test.cpp LIBS sinew::character LABELS integration)
endif()
