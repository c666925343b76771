# SPDX-License-Identifier: MIT
# The Blender add-on of samples/blender, from its zip.
if(TARGET sinew_cli AND TARGET sinew_character_shared AND UNIX AND NOT SINEW_SANITIZE)
  add_test(NAME blender_addon
    COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/blender_test.sh ${CMAKE_SOURCE_DIR} $<TARGET_FILE:sinew_character_shared> $<TARGET_FILE:sinew_cli>
    ${CMAKE_BINARY_DIR}/blender_test)
  set_tests_properties(blender_addon PROPERTIES LABELS "blender;tools" COST 300 TIMEOUT 1800 SKIP_RETURN_CODE 77)
endif()
