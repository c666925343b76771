# SPDX-License-Identifier: MIT
sinew_test(network_engine_unit_test
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/influences_test.cpp ${CMAKE_CURRENT_LIST_DIR}/skinning_test.cpp
  LIBS sinew::engine_internals
  LABELS unit)
if(SINEW_BUILD_QUANT)
  sinew_test(network_quant_unit_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/model_reader_test.cpp ${CMAKE_CURRENT_LIST_DIR}/quantize_test.cpp
    LIBS sinew::quant sinew::engine_internals
    LABELS unit)
endif()
