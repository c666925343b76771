# SPDX-License-Identifier: MIT
# The target sinew_host for WebAssembly: formats and character without Assimp, the command's jobs with the bundled models, sinew/character.h.
# The page's module and that of samples/npm/src/character.js are made of it; engine.cmake comes first. Compiled here, or with
# SINEW_HOST_ARCHIVE the archive that somebody compiled with the same flags (build_host in modules.sh).
get_filename_component(sinew_root ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
# Header-only libraries of the host. Its include folder as a whole would bring its C library too.
set(headers ${CMAKE_CURRENT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(header tiny_gltf.h tiny_obj_loader.h nlohmann eigen3/Eigen)
  find_file(at_${header} ${header} PATHS /usr/include /usr/local/include /opt/homebrew/include
    PATH_SUFFIXES x86_64-linux-gnu aarch64-linux-gnu NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  get_filename_component(name ${header} NAME)
  file(CREATE_LINK ${at_${header}} ${headers}/${name} SYMBOLIC)
endforeach()
# PNG and JPEG; without it they are refused (Debian: libstb-dev).
find_file(at_stb stb_image.h PATHS /usr/include/stb /usr/include /usr/local/include/stb /opt/homebrew/include/stb NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
if(at_stb)
  file(CREATE_LINK ${at_stb} ${headers}/stb_image.h SYMBOLIC)
endif()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/libraries.cpp CONTENT  # written only when it changes
  "#define TINYOBJLOADER_IMPLEMENTATION\n#include <tiny_obj_loader.h>\n")
add_library(libraries STATIC ${CMAKE_CURRENT_BINARY_DIR}/libraries.cpp)
target_include_directories(libraries SYSTEM PUBLIC ${headers})
target_compile_features(libraries PUBLIC cxx_std_20)
# The tools' errors are exceptions; the engine has none. WebAssembly's own cost no code where nothing is thrown: emscripten's, in JavaScript, wrap each call.
target_compile_options(libraries PUBLIC -fwasm-exceptions -Os)  # small before fast: the engine alone is worth -O3
target_link_options(libraries PUBLIC -fwasm-exceptions)

set(formats ${sinew_root}/formats)
include(${formats}/sources.cmake)
include(${sinew_root}/character/sources.cmake)
# Not joined with others: the page's module has no models, and links none of them.
set(bundled ${sinew_job_sources})
list(FILTER bundled INCLUDE REGEX "/bundled_[a-z_]*model[.]cpp$")
set_source_files_properties(${bundled} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
set(SINEW_HOST_ARCHIVE "" CACHE FILEPATH "libsinew_host.a of emscripten; empty = compile it")
if(SINEW_HOST_ARCHIVE)
  add_library(sinew_host INTERFACE)
  target_link_libraries(sinew_host INTERFACE ${SINEW_HOST_ARCHIVE})
  set(sinew_host_use INTERFACE)
else()
  add_library(sinew_host STATIC ${sinew_formats_sources} ${sinew_picture_sources} ${sinew_character_sources} ${sinew_job_sources}
    ${sinew_root}/samples/npm/wasm/read_scene.cpp)
  target_compile_definitions(sinew_host PRIVATE SINEW_SCENES_ELSEWHERE $<$<BOOL:${at_stb}>:SINEW_PICTURES_BY_STB>)
  sinew_rooms_as_one(sinew_host)
  set(sinew_host_use PUBLIC)
endif()
target_include_directories(sinew_host ${sinew_host_use} ${formats}/include ${formats}/src ${sinew_root}/character/include ${sinew_root}/character/src)
target_link_libraries(sinew_host ${sinew_host_use} sinew_engine_internals libraries sinew_build_flags)
