# SPDX-License-Identifier: MIT
if(SINEW_BUILD_QUANT)
  sinew_test(network_executor_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/executor_test.cpp
    LIBS sinew::quant sinew::engine_internals
    LABELS integration)
  # The same comparison with the reader, plan and kernels compiled as for a host that cannot load the file's int16 directly. Not where the archive's
  # sources were compiled as one: its members would bring those of the test again.
  if(NOT SINEW_UNITY STREQUAL ALL)
    set(engine_src ${PROJECT_SOURCE_DIR}/engine/src)
    sinew_test(network_portable_bytes_test
      SOURCES ${CMAKE_CURRENT_LIST_DIR}/executor_test.cpp ${engine_src}/model/reader.cpp ${engine_src}/network/plan.cpp
              ${engine_src}/network/network.cpp ${engine_src}/network/run.cpp ${engine_src}/network/tables.cpp
              ${engine_src}/network/tile_layers.cpp ${engine_src}/kernels/packed.cpp ${engine_src}/kernels/linear_s16_ref.cpp
              ${engine_src}/kernels/aggregate_s16_ref.cpp
      LIBS sinew::quant sinew::engine_internals
      LABELS integration)
    target_compile_definitions(network_portable_bytes_test PRIVATE SINEW_PORTABLE_BYTES
                               Executor=ExecutorPortable)  # another suite name, so that ctest tells the two apart
  endif()
endif()
