# SPDX-License-Identifier: MIT
# The command by programs of other makers (npm ci --prefix tests/support/FOLDER): `sinew serve --mcp` by the protocol's own client, outputs of --json
# against their schemas, USD in three's loader, VRM and springs in @pixiv/three-vrm.
if(TARGET sinew_cli)
  find_program(SINEW_NODE node)
  if(SINEW_NODE)
    foreach(one "mcp|@modelcontextprotocol/sdk|client" "mcp|@modelcontextprotocol/sdk|schemas" "three|three|usd" "three|three|vrm" "three|three|springs")
      string(REPLACE "|" ";" words ${one})
      list(GET words 0 folder)
      list(GET words 2 test)
      add_test(NAME ${folder}_${test} COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/npm_tools_test.sh ${words} ${SINEW_NODE} $<TARGET_FILE:sinew_cli>
        ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/${folder}_test)
      set_tests_properties(${folder}_${test} PROPERTIES LABELS "integration;tools" SKIP_RETURN_CODE 77 TIMEOUT 120)
    endforeach()
  endif()
endif()
