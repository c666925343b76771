# SPDX-License-Identifier: MIT
# The C# binding of samples/csharp, with Mono.
if(TARGET sinew_cli AND TARGET sinew_engine_shared AND TARGET sinew_character_shared AND UNIX AND NOT SINEW_SANITIZE)
  add_test(NAME csharp_binding
    COMMAND ${CMAKE_SOURCE_DIR}/tests/integration/csharp_test.sh ${CMAKE_SOURCE_DIR} $<TARGET_FILE:sinew_engine_shared> $<TARGET_FILE:sinew_cli>
    ${CMAKE_BINARY_DIR}/csharp_test $<TARGET_FILE:sinew_character_shared>)
  set_tests_properties(csharp_binding PROPERTIES LABELS "csharp;tools" TIMEOUT 300 SKIP_RETURN_CODE 77)
endif()
