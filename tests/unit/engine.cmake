# SPDX-License-Identifier: MIT
# One folder of engine/src, one program.
foreach(room api core names grid mesh skeleton motion springs reduce voxels rig mapping simplify candidates solve heat spectral features weights deform bind transfer published front votes details)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/engine/${room}/*_test.cpp)
  sinew_test(unit_engine_${room} SOURCES ${sources} LIBS sinew::engine_internals LABELS unit)
endforeach()
sinew_test(unit_engine_cpp_wrapper SOURCES ${CMAKE_CURRENT_LIST_DIR}/engine/cpp_wrapper_test.cpp LIBS sinew::engine_internals LABELS unit)
if(SINEW_BUILD_QUANT)  # writes the models that it opens
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/engine/model/*_test.cpp ${CMAKE_CURRENT_LIST_DIR}/engine/network/*_test.cpp)
  sinew_test(unit_engine_model SOURCES ${sources} LIBS sinew::quant sinew::engine_internals LABELS unit)
endif()
