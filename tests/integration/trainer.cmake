# SPDX-License-Identifier: MIT
if(TARGET sinew_trainer)
  sinew_test(trainer_run_test SOURCES ${CMAKE_CURRENT_LIST_DIR}/trainer_run_test.cpp LIBS sinew::trainer LABELS integration)
  target_include_directories(trainer_run_test PRIVATE ${CMAKE_SOURCE_DIR}/trainer/src)
  sinew_test(crossval_run_test SOURCES ${CMAKE_CURRENT_LIST_DIR}/crossval_run_test.cpp LIBS sinew::trainer LABELS integration)
endif()
