# SPDX-License-Identifier: MIT
sinew_test(sinew_map_property_test SOURCES property/map_property_test.cpp LIBS sinew::engine_internals LABELS property)
