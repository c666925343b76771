# SPDX-License-Identifier: MIT
if(SINEW_BUILD_QUANT)
  sinew_test(network_executor_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/executor_test.cpp
    LIBS sinew::quant sinew::engine_internals
    LABELS integration)
endif()
