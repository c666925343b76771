# SPDX-License-Identifier: MIT
sinew_test(sinew_motion_property_test SOURCES property/motion_property_test.cpp LIBS sinew::engine_internals LABELS property)
