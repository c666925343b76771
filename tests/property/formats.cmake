# SPDX-License-Identifier: MIT
if(SINEW_BUILD_FORMATS)
  find_library(SINEW_RAPIDCHECK rapidcheck REQUIRED)
  sinew_test(formats_property_test SOURCES property/formats_property_test.cpp LIBS sinew::data_sets ${SINEW_RAPIDCHECK} LABELS property)
endif()
