# SPDX-License-Identifier: MIT
# One folder of formats/picture/src, one program.
if(SINEW_BUILD_FORMATS)
  foreach(room draw read outline mesh)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/picture/${room}/*_test.cpp)
    sinew_test(unit_picture_${room} SOURCES ${sources} support/small_pictures.cpp LIBS sinew::picture LABELS unit)
    target_include_directories(unit_picture_${room} PRIVATE ${CMAKE_SOURCE_DIR}/formats/picture/src)
    foreach(library PNG JPEG)
      if(SINEW_HAS_${library})
        target_compile_definitions(unit_picture_${room} PRIVATE SINEW_HAS_${library})
      endif()
    endforeach()
  endforeach()
  if(SINEW_HAS_JPEG)  # files to read are made by it
    target_link_libraries(unit_picture_read PRIVATE JPEG::JPEG)
  endif()
endif()
