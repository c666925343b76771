# SPDX-License-Identifier: MIT
# Debian's MinGW-w64 for 64-bit Windows, linked statically so that one file runs under wine or on the device.
#   cmake -S engine -B build/windows --toolchain engine/cmake/toolchains/windows.cmake
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static")
find_program(SINEW_EMULATOR NAMES wine wine64)
if(SINEW_EMULATOR)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${SINEW_EMULATOR})
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
