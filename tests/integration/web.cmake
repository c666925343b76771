# SPDX-License-Identifier: MIT
# The page of samples/web: built by emscripten, tried in a headless Chromium.
find_program(SINEW_NODE node)
find_program(SINEW_EMCC emcc)
find_program(SINEW_ZOPFLI zopfli)
find_program(SINEW_CHROMIUM NAMES chromium google-chrome google-chrome-stable chromium-browser)
set(web ${CMAKE_SOURCE_DIR}/samples/web)
if(SINEW_NODE)
  add_test(NAME web_files COMMAND ${SINEW_NODE} ${web}/test/files_test.mjs)
  add_test(NAME web_skeleton COMMAND ${SINEW_NODE} ${web}/test/skeleton_test.mjs)
  add_test(NAME web_history COMMAND ${SINEW_NODE} ${web}/test/history_test.mjs)
  add_test(NAME web_panels COMMAND ${SINEW_NODE} ${web}/test/panels_test.mjs)
  set_tests_properties(web_files web_history web_skeleton web_panels PROPERTIES LABELS "web")
  add_test(NAME web_scripts COMMAND ${SINEW_NODE} ${web}/test/scripts_test.mjs)
  set_tests_properties(web_scripts PROPERTIES LABELS "web;tools" RESOURCE_LOCK web_packages TIMEOUT 300)
endif()
if(NOT (SINEW_NODE AND SINEW_EMCC AND SINEW_ZOPFLI AND SINEW_CHROMIUM AND TARGET sinew_cli))
  message(STATUS "sinew: no test of samples/web: it needs node, emcc, zopfli, a Chromium and the command; scripts/test.sh installs them")
  return()
endif()
# Page, package and the tests of kernels have one build of the engine, with SIMD and without: not two at a time.
add_test(NAME web_build COMMAND ${web}/build.sh ${CMAKE_BINARY_DIR}/web)
set_tests_properties(web_build PROPERTIES LABELS "web;tools" COST 900 TIMEOUT 1200 FIXTURES_SETUP web
  ENVIRONMENT SINEW_WASM_ENGINE=${CMAKE_BINARY_DIR}/wasm_engine RESOURCE_LOCK "wasm_engine;web_packages")
foreach(name first page studio moves scenes binds work loss shape drawing springs export access firefox)
  add_test(NAME web_${name} COMMAND ${CMAKE_COMMAND} -E env SINEW_CHROMIUM=${SINEW_CHROMIUM} ${SINEW_NODE} ${web}/test/${name}_test.mjs
    ${CMAKE_BINARY_DIR}/web ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/web_screenshots_${name} $<TARGET_FILE:sinew_cli>)
  set_tests_properties(web_${name} PROPERTIES LABELS "web;tools" COST 300 TIMEOUT 1200 FIXTURES_REQUIRED web)
endforeach()
set_tests_properties(web_firefox PROPERTIES SKIP_RETURN_CODE 77)  # where there is none
