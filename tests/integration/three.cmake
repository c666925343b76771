# SPDX-License-Identifier: MIT
# Files of the command in loaders of other makers: USD in three's, VRM in @pixiv/three-vrm (npm ci --prefix tests/support/three).
if(TARGET sinew_cli)
  find_program(SINEW_NODE node)
  if(SINEW_NODE)
    foreach(test usd vrm)
      add_test(NAME three_${test} COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/three_test.sh ${test} ${SINEW_NODE} $<TARGET_FILE:sinew_cli>
        ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/three_test)
    endforeach()
    set_tests_properties(three_usd three_vrm PROPERTIES LABELS "integration;tools" SKIP_RETURN_CODE 77 TIMEOUT 120)
  endif()
endif()
