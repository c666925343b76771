# SPDX-License-Identifier: MIT
# Declarations for other languages are what the headers say; skipped, with a line, without libclang.
if(UNIX AND NOT SINEW_SANITIZE)
  add_test(NAME declarations COMMAND ${CMAKE_SOURCE_DIR}/scripts/declarations.py --check)
  set_tests_properties(declarations PROPERTIES LABELS "python;csharp;tools" TIMEOUT 120 SKIP_RETURN_CODE 77)
endif()
