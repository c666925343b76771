# SPDX-License-Identifier: MIT
if(SINEW_BUILD_FORMATS)
  find_package(nlohmann_json REQUIRED)
  sinew_test(formats_text_test SOURCES unit/formats_text_test.cpp unit/decimal_test.cpp LIBS sinew::formats LABELS unit)
  sinew_test(formats_gltf_test SOURCES unit/formats_gltf_test.cpp LIBS sinew::formats nlohmann_json::nlohmann_json LABELS unit)
  sinew_test(formats_dataset_test SOURCES unit/formats_dataset_test.cpp unit/formats_checkpoint_test.cpp LIBS sinew::formats LABELS unit)
  sinew_test(label_check_test SOURCES unit/label_check_test.cpp LIBS sinew::formats LABELS unit)
  sinew_test(dataset_tools_test SOURCES unit/dataset_tools_test.cpp LIBS sinew::formats LABELS unit)
endif()
