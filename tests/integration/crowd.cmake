# SPDX-License-Identifier: MIT
# The page of samples/crowd in a headless Chromium, with textures by the command.
find_program(SINEW_NODE node)
find_program(SINEW_CHROMIUM NAMES chromium google-chrome google-chrome-stable chromium-browser)
if(SINEW_NODE AND SINEW_CHROMIUM AND TARGET sinew_cli)
  add_test(NAME web_crowd COMMAND ${CMAKE_COMMAND} -E env SINEW_CHROMIUM=${SINEW_CHROMIUM} ${SINEW_NODE} ${CMAKE_SOURCE_DIR}/samples/crowd/test/crowd_test.mjs
    ${CMAKE_SOURCE_DIR} $<TARGET_FILE:sinew_cli> ${CMAKE_BINARY_DIR}/web_crowd)
  set_tests_properties(web_crowd PROPERTIES LABELS "web;tools" COST 60 TIMEOUT 600 RESOURCE_LOCK web_packages)
endif()
