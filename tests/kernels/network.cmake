# SPDX-License-Identifier: MIT
if(SINEW_BUILD_QUANT)
  sinew_test(network_kernels_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/network_kernels_test.cpp
    LIBS sinew::quant sinew::engine_internals
    LABELS kernels)
  sinew_test(aggregate_variants_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/aggregate_variants_test.cpp
    LIBS sinew::quant sinew::engine_internals
    LABELS kernels)
  sinew_test(linear_variants_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/linear_variants_test.cpp
    LIBS sinew::quant sinew::engine_internals
    LABELS kernels)
endif()

sinew_test(heat_variants_test
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/heat_variants_test.cpp
  LIBS sinew::engine_internals
  LABELS kernels)

sinew_test(softmax_variants_test
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/softmax_variants_test.cpp
  LIBS sinew::engine_internals
  LABELS kernels)

# Optimised x86-64 code alone is worth looking at.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$" AND CMAKE_BUILD_TYPE MATCHES "^Rel" AND NOT SINEW_SANITIZE
   AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  sinew_test(object_code_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/object_code_test.cpp
    LIBS sinew::engine_internals
    LABELS kernels)
  target_compile_definitions(object_code_test PRIVATE SINEW_ENGINE_LIBRARY="$<TARGET_FILE:sinew_engine>")
endif()
