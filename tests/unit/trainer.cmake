# SPDX-License-Identifier: MIT
if(TARGET sinew_trainer)
  foreach(part network loss optimizer)
    sinew_test(trainer_${part}_test SOURCES ${CMAKE_CURRENT_LIST_DIR}/trainer_${part}_test.cpp LIBS sinew::trainer LABELS unit)
    target_include_directories(trainer_${part}_test PRIVATE ${CMAKE_SOURCE_DIR}/trainer/src)
  endforeach()
  sinew_test(crossval_test SOURCES ${CMAKE_CURRENT_LIST_DIR}/crossval_test.cpp LIBS sinew::trainer LABELS unit)
endif()
