// SPDX-License-Identifier: MIT
// A motion of two joints for tests of clips and of retargeting.
#ifndef SINEW_TESTS_SUPPORT_SWINGING_MOTION_HPP
#define SINEW_TESTS_SUPPORT_SWINGING_MOTION_HPP

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Two joints, the second at (0 1 0); it turns by 0.1 radians a frame about z and the first walks along x.
inline Motion swing(size_t frames) {
  Motion motion;
  motion.name = "swing";
  motion.joints = {{"a", -1, {0, 0, 0}}, {"b", 0, {0, 1, 0}}};
  Clip clip = {"swing", 0.1, {}};
  for (size_t f = 0; f < frames; ++f) {
    const double t = static_cast<double>(f);
    clip.frames.push_back({{kNoRotation4, axis_rotation(2, 0.1 * t)}, {{t, 0, 0}, {0, 1, 0}}});
  }
  motion.clips.push_back(clip);
  return motion;
}

}  // namespace sinew
#endif
