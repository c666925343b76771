# SPDX-License-Identifier: MIT
if(TARGET sinew_trainer AND TARGET sinew_quant)
  sinew_test(sinew_quantisation_test SOURCES integration/quantisation_test.cpp LIBS sinew::trainer sinew::quant LABELS integration)
endif()
