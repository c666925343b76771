# SPDX-License-Identifier: MIT
# One folder of formats/datasets/src, one program.
if(SINEW_BUILD_FORMATS)
  find_package(PNG REQUIRED)
  foreach(room dataset picture synth)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/datasets/${room}/*_test.cpp)
    sinew_test(unit_datasets_${room} SOURCES ${sources} LIBS sinew::datasets PNG::PNG LABELS unit)
  endforeach()
endif()
