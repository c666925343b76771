# SPDX-License-Identifier: MIT
add_test(NAME install_and_consumer
  COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/consumer_test.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/consumer_test)
set_tests_properties(install_and_consumer PROPERTIES LABELS "tools" COST 200)

find_program(SINEW_MINGW x86_64-w64-mingw32-g++-posix)
find_program(SINEW_WINE wine)
if(SINEW_MINGW AND SINEW_WINE)
  add_test(NAME windows_install_and_consumer
    COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/windows_consumer_test.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/windows_consumer_test)
  set_tests_properties(windows_install_and_consumer PROPERTIES LABELS "tools" COST 400 TIMEOUT 1200)
else()
  message(STATUS "sinew: no test of the DLL for Windows: it needs g++-mingw-w64-x86-64-posix and wine; scripts/test.sh installs them")
endif()
