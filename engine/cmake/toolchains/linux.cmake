# SPDX-License-Identifier: MIT
# Debian's cross compilers for Linux, linked statically so that one file runs under qemu-user or on the device.
#   cmake -S engine -B build/aarch64 --toolchain engine/cmake/toolchains/linux.cmake -DSINEW_CROSS=aarch64-linux-gnu
# SINEW_CROSS: aarch64-linux-gnu, arm-linux-gnueabihf, riscv64-linux-gnu, s390x-linux-gnu or another of Debian's names.
set(SINEW_CROSS "aarch64-linux-gnu" CACHE STRING "The compilers' prefix without its last dash")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SINEW_CROSS)
string(REGEX MATCH "^[a-z0-9_]+" CMAKE_SYSTEM_PROCESSOR "${SINEW_CROSS}")
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER ${SINEW_CROSS}-gcc)
set(CMAKE_CXX_COMPILER ${SINEW_CROSS}-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
find_program(SINEW_EMULATOR NAMES qemu-${CMAKE_SYSTEM_PROCESSOR}-static qemu-${CMAKE_SYSTEM_PROCESSOR})
if(SINEW_EMULATOR)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${SINEW_EMULATOR})
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
