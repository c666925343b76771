# SPDX-License-Identifier: MIT
find_library(SINEW_RAPIDCHECK rapidcheck REQUIRED)
sinew_test(sinew_mesh_property_test SOURCES property/mesh_property_test.cpp LIBS sinew::engine_internals ${SINEW_RAPIDCHECK}
           LABELS property)
