# SPDX-License-Identifier: MIT
# `sinew serve --mcp` by the protocol's own client, and outputs of --json against their schemas (npm ci --prefix tests/support/mcp).
if(TARGET sinew_cli)
  find_program(SINEW_NODE node)
  if(SINEW_NODE)
    foreach(test client schemas)
      add_test(NAME mcp_${test} COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/mcp_test.sh ${test} ${SINEW_NODE} $<TARGET_FILE:sinew_cli>
        ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/mcp_test)
    endforeach()
    set_tests_properties(mcp_client mcp_schemas PROPERTIES LABELS "integration;tools" SKIP_RETURN_CODE 77 TIMEOUT 120)
  endif()
endif()
