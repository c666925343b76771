# SPDX-License-Identifier: MIT
find_program(SINEW_DPKG_SHLIBDEPS dpkg-shlibdeps)
if(TARGET sinew_cli AND SINEW_DPKG_SHLIBDEPS AND NOT SINEW_SANITIZE)
  add_test(NAME debian_package
    COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/package_test.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR} ${CMAKE_BINARY_DIR}/package_test)
  set_tests_properties(debian_package PROPERTIES LABELS "tools")
endif()
