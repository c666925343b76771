# SPDX-License-Identifier: MIT
# One folder of formats/src, one program.
if(SINEW_BUILD_FORMATS)
  find_package(nlohmann_json REQUIRED)
  foreach(room fbx files text gltf motion network usd)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/formats/${room}/*_test.cpp)
    sinew_test(unit_formats_${room} SOURCES ${sources} LIBS sinew::formats nlohmann_json::nlohmann_json LABELS unit)
    target_include_directories(unit_formats_${room} PRIVATE ${CMAKE_SOURCE_DIR}/formats/src)
  endforeach()
  target_link_libraries(unit_formats_motion PRIVATE sinew::character)  # poses to try shapes with
  # Compressed files are made by the libraries' own encoders.
  sinew_link_encoders(unit_formats_gltf)
  sinew_link_encoders(unit_formats_fbx)  # which says whether Assimp reads them back
endif()
