# SPDX-License-Identifier: MIT
find_program(SINEW_PYTHON python3)
if(SINEW_PYTHON)
  add_test(NAME type_names COMMAND ${SINEW_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/type_names_test.py ${CMAKE_SOURCE_DIR})
  set_tests_properties(type_names PROPERTIES LABELS "unit")
endif()
