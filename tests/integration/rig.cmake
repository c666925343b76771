# SPDX-License-Identifier: MIT
if(TARGET sinew_formats)
  sinew_test(rig_test SOURCES integration/rig_test.cpp LIBS sinew::character sinew::engine_internals LABELS integration)
  sinew_test(lone_hand_test SOURCES integration/lone_hand_test.cpp LIBS sinew::character sinew::engine_internals LABELS integration)
  sinew_test(rig_front_test SOURCES integration/rig_front_test.cpp LIBS sinew::character sinew::engine_internals LABELS integration)
endif()
sinew_test(hands_test SOURCES integration/hands_test.cpp LIBS sinew::engine_internals LABELS integration)
