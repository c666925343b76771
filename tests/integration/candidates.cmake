# SPDX-License-Identifier: MIT
if(SINEW_BUILD_FORMATS)
  sinew_test(sinew_candidates_recall_test SOURCES integration/candidates_recall_test.cpp LIBS sinew::engine_internals sinew::formats
             LABELS integration shared)
endif()
