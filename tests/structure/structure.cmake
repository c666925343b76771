# SPDX-License-Identifier: MIT
# Who includes whom, by the READMEs' order, and no two types of one name in a namespace. Reads sources, builds nothing.
# The engine's sources are one translation unit without errors, in whatever batches CMAKE_UNITY_BUILD takes them. Kernels are empty here without their flags.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT MSVC)
  get_target_property(sources sinew_engine_objects SOURCES)
  list(TRANSFORM sources REPLACE "(.+)" "#include \"${CMAKE_SOURCE_DIR}/engine/\\1\"")
  list(JOIN sources "\n" sources)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/engine_as_one.cpp "${sources}\n")
  add_test(NAME structure_engine_as_one COMMAND ${CMAKE_CXX_COMPILER} -std=c++17 -fno-exceptions -fno-rtti -fsyntax-only
    -I${CMAKE_SOURCE_DIR}/engine/include -I${CMAKE_SOURCE_DIR}/engine/src ${CMAKE_CURRENT_BINARY_DIR}/engine_as_one.cpp)
  set_tests_properties(structure_engine_as_one PROPERTIES LABELS unit)
endif()
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  message(STATUS "sinew: no test of the structure: it needs python3; scripts/test.sh installs it")
  return()
endif()
foreach(check rooms type_names script_circles)
  add_test(NAME structure_${check} COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/structure/${check}.py ${CMAKE_SOURCE_DIR})
endforeach()
# Also: the table of extensions as front-ends have it, and that none has a list of its own.
add_test(NAME structure_file_kinds COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/scripts/file_kinds.py --check)
add_test(NAME structure_checks COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/structure/structure_test.py)
set_tests_properties(structure_rooms structure_type_names structure_script_circles structure_file_kinds structure_checks PROPERTIES LABELS unit)
