# SPDX-License-Identifier: MIT
if(TARGET sinew_lab_cli)
  find_package(nlohmann_json REQUIRED)
  sinew_test(cli_test SOURCES integration/cli_test.cpp integration/cli_folders_test.cpp integration/cli_tells_test.cpp
    integration/cli_joints_test.cpp integration/cli_questions_test.cpp integration/cli_rig_test.cpp
    integration/cli_rig_edit_test.cpp integration/cli_slots_test.cpp integration/cli_hands_test.cpp integration/cli_simplify_test.cpp integration/cli_springs_test.cpp integration/cli_vat_test.cpp integration/cli_map_test.cpp integration/cli_animate_test.cpp integration/cli_transfer_test.cpp
    integration/cli_bake_test.cpp integration/cli_like_test.cpp integration/cli_options_test.cpp integration/cli_convert_test.cpp integration/cli_lod_test.cpp integration/cli_picture_test.cpp integration/cli_serve_test.cpp integration/cli_profiles_test.cpp
    LIBS sinew::character nlohmann_json::nlohmann_json LABELS integration)
  target_include_directories(cli_test PRIVATE ${CMAKE_SOURCE_DIR}/formats/src)  # walking_motion.hpp
  add_dependencies(cli_test sinew_cli sinew_lab_cli)
  if(SINEW_HAS_ASSIMP)
    target_compile_definitions(cli_test PRIVATE SINEW_HAS_ASSIMP)
  endif()
endif()
if(TARGET sinew_hello_c)
  add_test(NAME hello_c COMMAND sinew_hello_c)
  set(hello_tests hello_c)
endif()
if(TARGET sinew_engine_shared)
  add_executable(sinew_hello_c_shared ${CMAKE_SOURCE_DIR}/samples/01_hello_c/hello.c)
  set_target_properties(sinew_hello_c_shared PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON LINKER_LANGUAGE C)
  if(SINEW_SANITIZE)  # what is in the library needs the C++ part of clang's runtime
    set_target_properties(sinew_hello_c_shared PROPERTIES LINKER_LANGUAGE CXX)
  endif()
  target_link_libraries(sinew_hello_c_shared PRIVATE sinew_engine_shared sinew_build_flags)
  add_test(NAME hello_c_shared COMMAND sinew_hello_c_shared)
  list(APPEND hello_tests hello_c_shared)
endif()
foreach(test ${hello_tests})
  set_tests_properties(${test} PROPERTIES LABELS integration
    PASS_REGULAR_EXPRESSION "vertex  0 at height 0: joint 0 65535/65535.*vertex 19 at height 4: joint 1 [56]"
    FAIL_REGULAR_EXPRESSION "hello:")
endforeach()
