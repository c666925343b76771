# SPDX-License-Identifier: MIT
if(TARGET sinew_cli)
  sinew_test(published_transfer_test SOURCES integration/published_transfer_test.cpp LIBS sinew::character LABELS integration)
  add_dependencies(published_transfer_test sinew_cli)
endif()
