# SPDX-License-Identifier: MIT
# Fuzz targets: the corpus in git as ordinary tests everywhere; libFuzzer programs with SINEW_BUILD_FUZZ.
if(NOT (SINEW_BUILD_FORMATS AND SINEW_BUILD_QUANT))
  return()
endif()
# sinew_fuzz(NAME CHANGES LIBS...): CHANGES = truncations, and changed bits, tried per corpus file in the replay.
function(sinew_fuzz name changes)
  set(source fuzz/${name}_fuzz.cpp)
  string(SUBSTRING ${name} 0 1 first)
  string(TOUPPER ${first} first)
  string(REGEX REPLACE "^." "${first}" suite ${name})
  sinew_test(sinew_fuzz_${name}_replay SOURCES fuzz/replay_test.cpp ${source} LIBS sinew::formats ${ARGN} LABELS fuzz)
  target_compile_definitions(sinew_fuzz_${name}_replay PRIVATE SINEW_FUZZ_SUITE=${suite}Fuzz SINEW_FUZZ_CHANGES=${changes}
    SINEW_FUZZ_CORPUS="${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus/${name}")
  if(SINEW_BUILD_FUZZ)
    add_executable(sinew_fuzz_${name} ${source})
    target_compile_features(sinew_fuzz_${name} PRIVATE cxx_std_20)
    target_include_directories(sinew_fuzz_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/support)
    target_compile_definitions(sinew_fuzz_${name} PRIVATE SINEW_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    target_link_libraries(sinew_fuzz_${name} PRIVATE sinew::formats ${ARGN} sinew_build_flags)
    target_link_options(sinew_fuzz_${name} PRIVATE -fsanitize=fuzzer)
  endif()
endfunction()
sinew_fuzz(obj 300)
sinew_fuzz(rig 300)
sinew_fuzz(glb 300)
sinew_fuzz(model 400 sinew::quant sinew::engine_internals)
sinew_fuzz(bind 60)

# Writes the binary part of the corpus again; the text files are written by hand.
add_executable(sinew_fuzz_seeds EXCLUDE_FROM_ALL fuzz/make_seeds.cpp)
target_compile_features(sinew_fuzz_seeds PRIVATE cxx_std_20)
target_include_directories(sinew_fuzz_seeds PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/support)
target_link_libraries(sinew_fuzz_seeds PRIVATE sinew::quant sinew::engine_internals nlohmann_json::nlohmann_json sinew_build_flags)
