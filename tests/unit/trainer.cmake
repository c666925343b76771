# SPDX-License-Identifier: MIT
# One folder of trainer/src, one program.
if(TARGET sinew_trainer)
  foreach(room core data network run score)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/trainer/${room}/*_test.cpp)
    sinew_test(unit_trainer_${room} SOURCES ${sources} LIBS sinew::trainer Eigen3::Eigen nlohmann_json::nlohmann_json LABELS unit)
    target_include_directories(unit_trainer_${room} PRIVATE ${CMAKE_SOURCE_DIR}/trainer/src)
    if(SINEW_TRAINER_ARCH)
      target_compile_definitions(unit_trainer_${room} PRIVATE Eigen=EigenOfTrainer)
    endif()
  endforeach()
endif()
