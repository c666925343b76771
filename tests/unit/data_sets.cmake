# SPDX-License-Identifier: MIT
# One room of trainer/data_sets/src, one program.
if(SINEW_BUILD_FORMATS)
  find_package(nlohmann_json REQUIRED)
  foreach(room dataset labels page synth)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/trainer/data_sets/${room}/*_test.cpp)
    sinew_test(unit_data_sets_${room} SOURCES ${sources} LIBS sinew::data_sets nlohmann_json::nlohmann_json LABELS unit)
  endforeach()
endif()
