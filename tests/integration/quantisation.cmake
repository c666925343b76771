# SPDX-License-Identifier: MIT
if(TARGET sinew_calibrate)
  sinew_test(sinew_quantisation_test SOURCES integration/quantisation_test.cpp LIBS sinew_calibrate LABELS integration)
endif()
