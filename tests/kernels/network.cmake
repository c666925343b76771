# SPDX-License-Identifier: MIT
if(SINEW_BUILD_QUANT)
  sinew_test(network_kernels_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/network_kernels_test.cpp
    LIBS sinew::quant sinew::engine_internals
    LABELS kernels)
endif()
