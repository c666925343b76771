# SPDX-License-Identifier: MIT
if(TARGET sinew_calibrate)
  sinew_test(sinew_spectral_model_test SOURCES integration/spectral_model_test.cpp LIBS sinew_calibrate LABELS integration)
endif()
