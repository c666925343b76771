# SPDX-License-Identifier: MIT
# One folder of formats/datasets/src, one program.
if(SINEW_BUILD_FORMATS)
  find_package(PNG REQUIRED)
  find_package(nlohmann_json REQUIRED)
  foreach(room dataset labels page picture synth)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/datasets/${room}/*_test.cpp)
    sinew_test(unit_datasets_${room} SOURCES ${sources} LIBS sinew::datasets PNG::PNG nlohmann_json::nlohmann_json LABELS unit)
  endforeach()
endif()
