# SPDX-License-Identifier: MIT
sinew_test(sinew_bind_property_test SOURCES property/bind_property_test.cpp LIBS sinew::engine LABELS property)
