# SPDX-License-Identifier: MIT
if(SINEW_BUILD_QUANT)
  sinew_test(unit_quant SOURCES ${CMAKE_CURRENT_LIST_DIR}/quant/quantize_test.cpp LIBS sinew::quant LABELS unit)
endif()
