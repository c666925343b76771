# SPDX-License-Identifier: MIT
# The plug-in of samples/godot, in Godot's headless editor.
if(TARGET sinew_cli AND UNIX AND NOT SINEW_SANITIZE)
  add_test(NAME godot_plugin
    COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/godot_test.sh ${CMAKE_SOURCE_DIR} $<TARGET_FILE:sinew_cli> ${CMAKE_BINARY_DIR}/godot_test)
  set_tests_properties(godot_plugin PROPERTIES LABELS "godot;tools" TIMEOUT 300 SKIP_RETURN_CODE 77)
endif()
