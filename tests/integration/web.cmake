# SPDX-License-Identifier: MIT
# The page of samples/web: built by emscripten, tried in a headless Chromium.
find_program(SINEW_NODE node)
find_program(SINEW_EMCC emcc)
find_program(SINEW_CHROMIUM NAMES chromium google-chrome google-chrome-stable chromium-browser)
set(web ${CMAKE_SOURCE_DIR}/samples/web)
if(SINEW_NODE)
  add_test(NAME web_files COMMAND ${SINEW_NODE} ${web}/test/files_test.mjs)
  add_test(NAME web_skeleton COMMAND ${SINEW_NODE} ${web}/test/skeleton_test.mjs)
  set_tests_properties(web_files web_skeleton PROPERTIES LABELS "web")
endif()
if(NOT (SINEW_NODE AND SINEW_EMCC AND SINEW_CHROMIUM AND TARGET sinew_cli))
  message(STATUS "sinew: no test of samples/web: it needs node, emcc, a Chromium and the command; scripts/test.sh installs them")
  return()
endif()
add_test(NAME web_build COMMAND ${web}/build.sh ${CMAKE_BINARY_DIR}/web)
add_test(NAME web_page COMMAND ${CMAKE_COMMAND} -E env SINEW_CHROMIUM=${SINEW_CHROMIUM} ${SINEW_NODE} ${web}/test/page_test.mjs
  ${CMAKE_BINARY_DIR}/web ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/web_screenshots $<TARGET_FILE:sinew_cli>)
add_test(NAME web_studio COMMAND ${CMAKE_COMMAND} -E env SINEW_CHROMIUM=${SINEW_CHROMIUM} ${SINEW_NODE} ${web}/test/studio_test.mjs
  ${CMAKE_BINARY_DIR}/web ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/web_screenshots_studio $<TARGET_FILE:sinew_cli>)
set_tests_properties(web_studio PROPERTIES LABELS "web;tools" TIMEOUT 1200 FIXTURES_REQUIRED web)
set_tests_properties(web_build PROPERTIES LABELS "web;tools" TIMEOUT 1200 FIXTURES_SETUP web RESOURCE_LOCK web_packages)
set_tests_properties(web_page PROPERTIES LABELS "web;tools" TIMEOUT 1200 FIXTURES_REQUIRED web)
