# SPDX-License-Identifier: MIT
if(SINEW_BUILD_FORMATS)
  find_package(PNG REQUIRED)
  sinew_test(numpy_random_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/numpy_random_test.cpp LIBS sinew::formats LABELS unit)
  target_include_directories(numpy_random_test PRIVATE ${CMAKE_SOURCE_DIR}/formats/src)
  sinew_test(pose_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/pose_test.cpp LIBS sinew::formats LABELS unit)
  sinew_test(render_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/render_test.cpp LIBS sinew::formats PNG::PNG LABELS unit)
endif()
if(SINEW_BUILD_TRAINER)
  sinew_test(evaluate_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/evaluate_test.cpp
             LIBS sinew::trainer nlohmann_json::nlohmann_json LABELS unit)
  sinew_test(report_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/report_test.cpp LIBS sinew::trainer LABELS unit)
  sinew_test(report_figures_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/report_figures_test.cpp LIBS sinew::trainer LABELS unit)
endif()
