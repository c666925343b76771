# SPDX-License-Identifier: MIT
add_test(NAME install_and_consumer
  COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/consumer_test.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/consumer_test)
set_tests_properties(install_and_consumer PROPERTIES LABELS "tools")
