# SPDX-License-Identifier: MIT
if(SINEW_BUILD_FORMATS)
  find_package(nlohmann_json REQUIRED)
  sinew_test(gltf_validator_test SOURCES integration/gltf_validator_test.cpp LIBS sinew::character nlohmann_json::nlohmann_json
             LABELS integration tools)
  target_include_directories(gltf_validator_test PRIVATE ${CMAKE_SOURCE_DIR}/formats/src)
  sinew_link_encoders(gltf_validator_test)
  sinew_test(formats_shared_test SOURCES integration/formats_shared_test.cpp LIBS sinew::data_sets LABELS integration shared tools)
endif()
