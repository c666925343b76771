# SPDX-License-Identifier: MIT
# One folder of formats/datasets/src, one program.
if(SINEW_BUILD_FORMATS)
  find_package(PNG REQUIRED)
  find_package(nlohmann_json REQUIRED)
  foreach(room bake dataset picture page synth target)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/datasets/${room}/*_test.cpp)
    sinew_test(unit_datasets_${room} SOURCES ${sources} LIBS sinew::datasets PNG::PNG nlohmann_json::nlohmann_json LABELS unit)
  endforeach()
  find_package(Eigen3 REQUIRED NO_MODULE)
  target_include_directories(unit_datasets_bake PRIVATE ${CMAKE_SOURCE_DIR}/formats/datasets/src)
  target_link_libraries(unit_datasets_bake PRIVATE Eigen3::Eigen)
endif()
