// SPDX-License-Identifier: MIT
// What readers of motions promise: a sound one, or one line.
#ifndef SINEW_TESTS_FUZZ_CLIP_CHECKS_HPP
#define SINEW_TESTS_FUZZ_CLIP_CHECKS_HPP

#include <cmath>

#include "reader_checks.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::test {

inline void check_clip(const Motion& motion, const Clip& clip) {
  demand(clip.frame_time > 0 && !clip.frames.empty(), "a clip has frames and a rate");
  for (const MotionFrame& frame : clip.frames) {
    demand(frame.rotations.size() == motion.joints.size() && frame.translations.size() == motion.joints.size(),
           "a frame has every joint");
    for (const Quaternion& q : frame.rotations)
      demand(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 1e-9, "turns have length 1");
    for (const Point3& p : frame.translations)
      for (const double x : p) demand(std::isfinite(x), "places are finite");
  }
}

// The joint tree and every clip of a file that is read; nothing where it is refused.
inline void check_motion_file(const std::string& path) {
  Motion motion;
  try {
    motion = read_motion(path);
  } catch (const Error& error) {
    return check_refusal(error.what(), path);
  }
  Character skeleton;
  skeleton.joints = rest_joints(motion);
  demand(!skeleton.joints.empty(), "a motion has joints");
  check_joints(skeleton);
  for (const Clip& clip : motion.clips) check_clip(motion, clip);
}

}  // namespace sinew::test
#endif
