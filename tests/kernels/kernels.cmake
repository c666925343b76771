# SPDX-License-Identifier: MIT
foreach(test network_kernels_test linear_variants_test aggregate_variants_test softmax_variants_test heat_variants_test constraints_variants_test)
  sinew_test(${test} SOURCES ${CMAKE_CURRENT_LIST_DIR}/${test}.cpp LIBS sinew::engine_internals LABELS kernels)
endforeach()

# Optimized x86-64 code alone is worth looking at.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$" AND CMAKE_BUILD_TYPE MATCHES "^Rel" AND NOT SINEW_SANITIZE
   AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  sinew_test(object_code_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/object_code_test.cpp
    LIBS sinew::engine_internals
    LABELS kernels)
  target_compile_definitions(object_code_test PRIVATE SINEW_ENGINE_LIBRARY="$<TARGET_FILE:sinew_engine>")
endif()
