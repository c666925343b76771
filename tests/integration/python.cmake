# SPDX-License-Identifier: MIT
# The Python package of samples/python, from its wheel.
if(TARGET sinew_cli AND TARGET sinew_character_shared AND UNIX AND NOT SINEW_SANITIZE)
  add_test(NAME python_wheel
    COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/python_test.sh ${CMAKE_SOURCE_DIR} $<TARGET_FILE:sinew_character_shared> $<TARGET_FILE:sinew_cli>
    ${CMAKE_BINARY_DIR}/python_test)
  set_tests_properties(python_wheel PROPERTIES LABELS "python;tools" TIMEOUT 600 SKIP_RETURN_CODE 77)
endif()
