# SPDX-License-Identifier: MIT
# arm-none-eabi for a Cortex-M without an operating system.
#   cmake -S engine -B build/m7 --toolchain engine/cmake/toolchains/cortex-m.cmake -DSINEW_CORTEX_M=m7
# SINEW_CORTEX_M: m3, m4, m7, m33 or m55. Another core: give its flags in SINEW_CORTEX_M_FLAGS.
set(SINEW_CORTEX_M "m7" CACHE STRING "Which core: m3, m4, m7, m33 or m55")
set(flags_m3 "-mcpu=cortex-m3")
set(flags_m4 "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16")
set(flags_m7 "-mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16")
set(flags_m33 "-mcpu=cortex-m33 -mfloat-abi=hard -mfpu=fpv5-sp-d16")
set(flags_m55 "-mcpu=cortex-m55 -mfloat-abi=hard")
set(SINEW_CORTEX_M_FLAGS "${flags_${SINEW_CORTEX_M}}" CACHE STRING "Compiler flags of the core")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SINEW_CORTEX_M SINEW_CORTEX_M_FLAGS)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_C_FLAGS_INIT "${SINEW_CORTEX_M_FLAGS} -mthumb -ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT}")
set(CMAKE_ASM_FLAGS_INIT "${SINEW_CORTEX_M_FLAGS} -mthumb")
# There is nothing to start a program with yet when CMake tries the compiler.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
