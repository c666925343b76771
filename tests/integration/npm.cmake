# SPDX-License-Identifier: MIT
# The package of samples/npm: built by emscripten, its tarball tried in fresh projects.
find_program(SINEW_NODE node)
find_program(SINEW_NPM npm)
find_program(SINEW_EMCC emcc)
find_program(SINEW_CHROMIUM NAMES chromium google-chrome google-chrome-stable chromium-browser)
set(npm ${CMAKE_SOURCE_DIR}/samples/npm)
if(NOT (SINEW_NODE AND SINEW_NPM AND SINEW_EMCC AND SINEW_CHROMIUM AND TARGET sinew_cli))
  message(STATUS "sinew: no test of samples/npm: it needs node, npm, emcc, a Chromium and the command; scripts/test.sh installs them")
  return()
endif()
add_test(NAME npm_build COMMAND ${npm}/build.sh ${CMAKE_BINARY_DIR}/npm)
add_test(NAME npm_package COMMAND ${CMAKE_COMMAND} -E env SINEW_CHROMIUM=${SINEW_CHROMIUM} ${SINEW_NODE} ${npm}/test/package_test.mjs
  ${CMAKE_BINARY_DIR}/npm ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/npm_projects $<TARGET_FILE:sinew_cli>)
set_tests_properties(npm_build PROPERTIES LABELS "npm;tools" COST 600 TIMEOUT 1200 FIXTURES_SETUP npm
  ENVIRONMENT SINEW_WASM_ENGINE=${CMAKE_BINARY_DIR}/wasm_engine RESOURCE_LOCK wasm_engine)  # as in web.cmake
set_tests_properties(npm_package PROPERTIES LABELS "npm;tools" COST 200 TIMEOUT 1200 FIXTURES_REQUIRED npm RESOURCE_LOCK web_packages)
