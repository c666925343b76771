# SPDX-License-Identifier: MIT
add_executable(hash_stages ${CMAKE_CURRENT_LIST_DIR}/hash_stages.cpp)
target_link_libraries(hash_stages PRIVATE sinew::engine_internals sinew_build_flags)
target_compile_options(hash_stages PRIVATE -ffp-contract=off)
add_test(NAME golden_all_compilers
  COMMAND ${CMAKE_SOURCE_DIR}/tests/golden/golden_test.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/golden $<TARGET_FILE:hash_stages>)
set_tests_properties(golden_all_compilers PROPERTIES LABELS "tools" COST 300 TIMEOUT 1200)
if(SINEW_BUILD_QUANT)
  sinew_test(golden_models_test SOURCES ${CMAKE_CURRENT_LIST_DIR}/models_test.cpp
             LIBS sinew::quant sinew::engine_internals LABELS golden)
endif()
