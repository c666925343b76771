# SPDX-License-Identifier: MIT
# Of the public interface alone: against the shared library where there is one.
if(TARGET sinew_engine_shared)
  set(public_engine sinew_engine_shared)
else()
  set(public_engine sinew::engine)
endif()
sinew_test(growing_structs_test SOURCES integration/growing_structs_test.cpp LIBS ${public_engine} LABELS integration)
