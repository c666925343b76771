# SPDX-License-Identifier: MIT
# One room of character/src, one program.
if(SINEW_BUILD_FORMATS)
  find_package(Eigen3 REQUIRED NO_MODULE)
  find_package(nlohmann_json REQUIRED)
  foreach(room rig bind predict pose bake clips motion springs crowd picture profile draw check jobs)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/character/${room}/*_test.cpp)
    sinew_test(unit_character_${room} SOURCES ${sources} LIBS sinew::character Eigen3::Eigen nlohmann_json::nlohmann_json LABELS unit)
    target_include_directories(unit_character_${room} PRIVATE ${CMAKE_SOURCE_DIR}/character/src ${CMAKE_SOURCE_DIR}/formats/src)
  endforeach()
  target_link_libraries(unit_character_check PRIVATE sinew::data_sets)  # which makes its characters
  target_link_libraries(unit_character_draw PRIVATE sinew::data_sets PNG::PNG)
  target_sources(unit_character_picture PRIVATE support/small_pictures.cpp)
  foreach(library PNG JPEG)  # files to read are made by them
    if(SINEW_HAS_${library})
      target_compile_definitions(unit_character_picture PRIVATE SINEW_HAS_${library})
      target_link_libraries(unit_character_picture PRIVATE ${library}::${library})
    endif()
  endforeach()
endif()
