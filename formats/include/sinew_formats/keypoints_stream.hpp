// SPDX-License-Identifier: MIT
// Keypoints of joints as they come, from a camera or a capture, to rotations of a person's joints: what a stream of
// sinew/motion_stream.h takes.
#ifndef SINEW_FORMATS_KEYPOINTS_STREAM_HPP
#define SINEW_FORMATS_KEYPOINTS_STREAM_HPP

#include <memory>
#include <string>
#include <vector>

#include "sinew_formats/motion.hpp"

namespace sinew {

class KeypointsSolver;
struct KeypointsLayout;

class KeypointsStream {
 public:
  //   layout  of motion_layouts()
  //   first   [frames][keypoints of the layout] of the person that moves, any unit: lengths of bones, which way is up, whether the world is
  //           mirrored and whether keypoints are relative to the hips are learnt from them. One will do; a second or two are better
  // Throws Error.
  KeypointsStream(const std::string& layout, const std::vector<std::vector<Point3>>& first);
  KeypointsStream(KeypointsStream&&) noexcept;
  ~KeypointsStream();

  // Joints with their keypoints at rest, y up, notes of what was found out, and `first` as a clip at the layout's own rate.
  const Motion& person() const;
  // Rotations and translations of person()'s joints in the frame of these keypoints, of this frame alone. Throws Error.
  MotionFrame next(const std::vector<Point3>& keypoints) const;

 private:
  void check(const std::vector<Point3>& row) const;

  const KeypointsLayout* layout_ = nullptr;
  std::unique_ptr<KeypointsSolver> solver_;
};

}  // namespace sinew
#endif
