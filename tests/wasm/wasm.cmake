# SPDX-License-Identifier: MIT
find_program(SINEW_EMCC emcc)
if(NOT SINEW_EMCC)
  message(STATUS "sinew: no tests of WebAssembly: emcc is not installed, see scripts/setup.sh")
  return()
endif()
add_test(NAME wasm_kernels COMMAND ${CMAKE_CURRENT_LIST_DIR}/kernels_test.sh ${CMAKE_BINARY_DIR}/wasm)
set_tests_properties(wasm_kernels PROPERTIES LABELS "web;tools" COST 200 TIMEOUT 600
  ENVIRONMENT SINEW_WASM_ENGINE=${CMAKE_BINARY_DIR}/wasm_engine RESOURCE_LOCK wasm_engine)  # as in integration/web.cmake
