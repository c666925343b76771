# SPDX-License-Identifier: MIT
# The C API of characters through its shared library.
if(TARGET sinew_character_shared AND TARGET sinew_cli)
  find_package(nlohmann_json REQUIRED)
  sinew_test(character_c_test SOURCES integration/character_c_test.cpp integration/picture_c_test.cpp LIBS sinew_character_shared nlohmann_json::nlohmann_json LABELS integration)
  # Headers of the fixture alone: the program links none of the archives.
  target_include_directories(character_c_test PRIVATE ${CMAKE_SOURCE_DIR}/formats/include)
  add_dependencies(character_c_test sinew_cli)

  if(TARGET sinew_character_c)
    add_test(NAME character_c COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/integration/character_c_test.sh
      $<TARGET_FILE:sinew_character_c> $<TARGET_FILE:sinew_character_shared> $<TARGET_FILE:sinew_cli> ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/character_c)
    set_tests_properties(character_c PROPERTIES LABELS integration)
  endif()
endif()
