# SPDX-License-Identifier: MIT
# The claim of the published correction on a sample.
if(TARGET sinew_character)
  sinew_test(published_xpbd_test SOURCES integration/published_xpbd_test.cpp LIBS sinew::character LABELS integration)
endif()
