# SPDX-License-Identifier: MIT
# What the table of words says of real joints.
if(TARGET sinew_character)
  sinew_test(joint_names_shared_test SOURCES integration/joint_names_shared_test.cpp LIBS sinew::character LABELS integration shared)
endif()
