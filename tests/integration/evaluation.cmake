# SPDX-License-Identifier: MIT
if(SINEW_BUILD_TRAINER)
  sinew_test(yardstick_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/integration/yardstick_test.cpp
             LIBS sinew::trainer nlohmann_json::nlohmann_json LABELS integration shared)
  sinew_test(rig_yardstick_test SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/integration/rig_yardstick_test.cpp
             LIBS sinew::trainer nlohmann_json::nlohmann_json LABELS integration shared)
endif()
