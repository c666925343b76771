# SPDX-License-Identifier: MIT
find_package(Eigen3 REQUIRED)
sinew_test(sinew_heat_agreement_test SOURCES integration/heat_agreement_test.cpp LIBS sinew::engine_internals Eigen3::Eigen LABELS integration shared reference)
