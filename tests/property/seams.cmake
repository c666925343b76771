# SPDX-License-Identifier: MIT
if(TARGET sinew_character)
  sinew_test(sinew_seams_property_test SOURCES property/seams_property_test.cpp LIBS sinew::character LABELS property shared)
endif()
