# SPDX-License-Identifier: MIT
if(TARGET sinew_cli)
  sinew_test(cli_test SOURCES integration/cli_test.cpp LIBS sinew::formats LABELS integration)
  add_dependencies(cli_test sinew_cli)
endif()
if(TARGET sinew_hello_c)
  add_test(NAME hello_c COMMAND sinew_hello_c)
  set_tests_properties(hello_c PROPERTIES LABELS integration
    PASS_REGULAR_EXPRESSION "vertex  0 at height 0: joint 0 65535/65535.*vertex 19 at height 4: joint 1 [56]"
    FAIL_REGULAR_EXPRESSION "hello:")
endif()
