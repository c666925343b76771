# SPDX-License-Identifier: MIT
if(TARGET sinew_trainer AND TARGET sinew_quant)
  sinew_test(sinew_quantization_test SOURCES integration/quantization_test.cpp LIBS sinew::trainer sinew::quant LABELS integration shared)
  target_include_directories(sinew_quantization_test PRIVATE ${CMAKE_SOURCE_DIR}/trainer/src)
endif()
if(TARGET sinew_trainer AND TARGET sinew_quant)
  sinew_test(second_task_test SOURCES integration/second_task_test.cpp LIBS sinew::trainer sinew::quant LABELS integration)
  target_include_directories(second_task_test PRIVATE ${CMAKE_SOURCE_DIR}/trainer/src)
endif()
