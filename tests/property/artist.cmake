# SPDX-License-Identifier: MIT
if(TARGET sinew_trainer)
  sinew_test(sinew_artist_property_test SOURCES property/artist_property_test.cpp LIBS sinew::trainer LABELS property)
  sinew_test(sinew_robustness_property_test SOURCES property/robustness_property_test.cpp support/robustness.cpp LIBS sinew::data_sets LABELS property)
endif()
