# SPDX-License-Identifier: MIT
# `sinew serve --mcp` by the protocol's own client (npm ci --prefix tests/support/mcp).
if(TARGET sinew_cli)
  find_program(SINEW_NODE node)
  if(SINEW_NODE)
    add_test(NAME mcp_client COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/mcp_test.sh ${SINEW_NODE} $<TARGET_FILE:sinew_cli>
      ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/mcp_test)
    set_tests_properties(mcp_client PROPERTIES LABELS "integration;tools" SKIP_RETURN_CODE 77 TIMEOUT 120)
  endif()
endif()
