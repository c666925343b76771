# SPDX-License-Identifier: MIT
if(TARGET sinew_trainer AND TARGET sinew_quant)
  sinew_test(sinew_spectral_model_test SOURCES integration/spectral_model_test.cpp LIBS sinew::trainer sinew::quant LABELS integration)
endif()
