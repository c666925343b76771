# SPDX-License-Identifier: MIT
# The engine for WebAssembly as the target sinew_engine_internals: compiled here, or with SINEW_ENGINE_ARCHIVE the archive that somebody
# compiled with the same flags (build_engine in tests/wasm/emscripten.sh).
get_filename_component(sinew_engine ${CMAKE_CURRENT_LIST_DIR}/../../../engine ABSOLUTE)
set(SINEW_ENGINE_ARCHIVE "" CACHE FILEPATH "libsinew.a of emscripten; empty = compile the engine")
if(SINEW_ENGINE_ARCHIVE)
  add_library(sinew_engine_internals INTERFACE)
  target_include_directories(sinew_engine_internals INTERFACE ${sinew_engine}/include ${sinew_engine}/src)
  target_link_libraries(sinew_engine_internals INTERFACE ${SINEW_ENGINE_ARCHIVE})
else()
  add_subdirectory(${sinew_engine} engine)
endif()
