# SPDX-License-Identifier: MIT
# One folder of formats/character/src, one program.
if(SINEW_BUILD_FORMATS)
  find_package(Eigen3 REQUIRED NO_MODULE)
  find_package(nlohmann_json REQUIRED)
  foreach(room bake bind clips map motion picture pose predict profile rig)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/character/${room}/*_test.cpp)
    sinew_test(unit_character_${room} SOURCES ${sources} LIBS sinew::character Eigen3::Eigen nlohmann_json::nlohmann_json LABELS unit)
    target_include_directories(unit_character_${room} PRIVATE ${CMAKE_SOURCE_DIR}/formats/character/src ${CMAKE_SOURCE_DIR}/formats/src)
  endforeach()
  # Its characters are made by datasets.
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/character/check/*_test.cpp)
  sinew_test(unit_character_check SOURCES ${sources} LIBS sinew::datasets nlohmann_json::nlohmann_json LABELS unit)
  target_include_directories(unit_character_check PRIVATE ${CMAKE_SOURCE_DIR}/formats/character/src ${CMAKE_SOURCE_DIR}/formats/src)
endif()
