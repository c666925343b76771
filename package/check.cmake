# SPDX-License-Identifier: MIT
# cpack reads this first: stops for what would make a package that fails on another machine.
if(CPACK_SINEW_TRAINER_ARCH AND NOT CPACK_SINEW_THIS_MACHINE)
  message(FATAL_ERROR "sinew: the trainer was built with -march=${CPACK_SINEW_TRAINER_ARCH}, so that a package would fail on other processors; "
                      "configure with `cmake --preset package`, or give cpack -D CPACK_SINEW_THIS_MACHINE=ON for a package that stays here")
endif()
if(CPACK_GENERATOR STREQUAL "DEB")
  foreach(program dpkg-shlibdeps file)  # without them cpack leaves the dependencies out
    find_program(found_${program} ${program})
    if(NOT found_${program})
      message(FATAL_ERROR "sinew: cpack needs ${program} for the package's dependencies; install dpkg-dev and file")
    endif()
  endforeach()
endif()
