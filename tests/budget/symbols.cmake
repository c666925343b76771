# SPDX-License-Identifier: MIT
# Sanitizers add symbols and data of their own: this looks at the library that users link.
if(NOT SINEW_SANITIZE)
  sinew_test(sinew_symbols_test SOURCES budget/symbols_test.cpp LIBS sinew::engine LABELS budget)
  target_compile_definitions(sinew_symbols_test PRIVATE SINEW_ENGINE_LIBRARY="$<TARGET_FILE:sinew_engine>")
endif()
