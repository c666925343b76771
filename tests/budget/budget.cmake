# SPDX-License-Identifier: MIT
# Sanitizers add symbols, data and stack of their own: this looks at the library that users link.
if(NOT SINEW_SANITIZE)
  sinew_test(sinew_symbols_test SOURCES budget/symbols_test.cpp LIBS sinew::engine_internals LABELS budget)
  target_compile_definitions(sinew_symbols_test PRIVATE SINEW_ENGINE_LIBRARY="$<TARGET_FILE:sinew_engine>")
  if(TARGET sinew_engine_shared AND UNIX AND NOT APPLE)
    add_dependencies(sinew_symbols_test sinew_engine_shared)
    target_compile_definitions(sinew_symbols_test PRIVATE SINEW_ENGINE_SHARED="$<TARGET_FILE:sinew_engine_shared>")
  endif()
  # Debian 12's GCC, -O3, x86-64; another compiler's code has another size.
  # 88 kB of it came with the published methods as published: surface distances, capsules, springs, two networks of slots, joints of branches, arms that come out of the body.
  # 26 kB find up and front. 12 kB join roots of one body and read the names of bodies without legs. 28 kB keep the whole body on the floor, in clips and streams. 10 kB hold joints within limits. 16 kB read strangers' bodies in maps. 22 kB are chains that swing. 2 kB spread arms.
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU"
     AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_definitions(sinew_symbols_test PRIVATE SINEW_TEXT_BUDGET=1425000)
  endif()
  if(CMAKE_BUILD_TYPE MATCHES "^Rel" AND UNIX)
    find_package(Threads REQUIRED)
    sinew_test(sinew_stack_test SOURCES budget/stack_test.cpp LIBS sinew::engine Threads::Threads LABELS budget)
  endif()
  find_program(SINEW_ARM_GCC arm-none-eabi-g++)
  find_program(SINEW_QEMU_ARM qemu-system-arm)
  if(SINEW_ARM_GCC AND SINEW_QEMU_ARM)
    add_test(NAME budget_embedded COMMAND ${CMAKE_SOURCE_DIR}/tests/budget/embedded_test.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/embedded)
    set_tests_properties(budget_embedded PROPERTIES LABELS "budget;tools" COST 400 TIMEOUT 900)
  else()
    message(STATUS "sinew: no test of samples/embedded: run scripts/setup.sh $(scripts/conformance.sh --packages cortex-m7)")
  endif()
endif()

# What SINEW_SMALL_CODE refuses, and that the rest of it works.
get_target_property(small_sources sinew_engine_objects SOURCES)
list(FILTER small_sources EXCLUDE REGEX "src/api/(corresponding_points|deform|map|motion|names|rig|simplify|springs|struct_sizes|transfer)\\.cpp|src/(deform|details|front|mapping|motion|names|published|rig|simplify|springs|transfer|votes)/")
list(APPEND small_sources src/api/left_out.cpp src/deform/skinning.cpp)
list(TRANSFORM small_sources PREPEND ${CMAKE_SOURCE_DIR}/engine/)
add_library(sinew_engine_small STATIC ${small_sources})
target_compile_features(sinew_engine_small PUBLIC cxx_std_17)
target_include_directories(sinew_engine_small PUBLIC ${CMAKE_SOURCE_DIR}/engine/include PRIVATE ${CMAKE_SOURCE_DIR}/engine/src)
target_compile_definitions(sinew_engine_small PRIVATE SINEW_SMALL_CODE)
target_compile_options(sinew_engine_small PRIVATE -fno-exceptions -fno-rtti $<$<AND:$<CONFIG:Release>,$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>>:-O1>)
target_link_libraries(sinew_engine_small PRIVATE sinew_build_flags)
sinew_test(small_code_test SOURCES budget/small_code_test.cpp LIBS sinew_engine_small LABELS budget)

# What SINEW_PUBLISHED_METHODS=OFF leaves out, and that nothing else needs it: the stub is linked first, the archive has the rest. Not where the
# archive's sources were compiled as one: its members would bring the stub's names again.
if(SINEW_PUBLISHED_METHODS AND NOT SINEW_SMALL_CODE AND NOT SINEW_UNITY STREQUAL ALL)
  add_library(sinew_engine_plain OBJECT ${CMAKE_SOURCE_DIR}/engine/src/published/none.cpp)  # an archive would lose against the other
  target_compile_features(sinew_engine_plain PUBLIC cxx_std_17)
  target_include_directories(sinew_engine_plain PUBLIC ${CMAKE_SOURCE_DIR}/engine/include PRIVATE ${CMAKE_SOURCE_DIR}/engine/src)
  target_compile_options(sinew_engine_plain PRIVATE $<TARGET_PROPERTY:sinew_engine_objects,COMPILE_OPTIONS>)
  target_link_libraries(sinew_engine_plain PRIVATE sinew_build_flags)
  sinew_test(without_published_test SOURCES budget/without_published_test.cpp LIBS sinew_engine_plain sinew_engine LABELS budget)
  target_compile_definitions(without_published_test PRIVATE SINEW_TEST_PROGRAM="$<TARGET_FILE:without_published_test>")
endif()
