# SPDX-License-Identifier: MIT
sinew_test(sinew_rig_property_test SOURCES property/rig_property_test.cpp LIBS sinew::engine_internals LABELS property)
