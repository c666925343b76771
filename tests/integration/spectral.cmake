# SPDX-License-Identifier: MIT
if(SINEW_BUILD_FORMATS)
  find_package(Eigen3 REQUIRED)
  find_package(Spectra REQUIRED)
  sinew_test(sinew_spectral_agreement_test SOURCES integration/spectral_agreement_test.cpp
             LIBS sinew::engine_internals sinew::formats Eigen3::Eigen Spectra::Spectra LABELS integration shared reference)
endif()
