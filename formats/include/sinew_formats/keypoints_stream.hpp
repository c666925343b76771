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
  //           mirrored and whether keypoints are relative to the hips are learned from them. One will do; a second or two are better
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

// Which numbers of a row stand for which joint.
struct KeypointsLayout {
  const char* name;  // "coco17"
  size_t count;      // keypoints in a row
  double fps;        // where a file says none
  struct Joint {
    const char* name;             // of person_joints(); "left" ones stand for both sides
    std::vector<size_t> columns;  // their middle; of "left" ones the left's
    std::vector<size_t> right = {};
  };
  std::vector<Joint> joints;
};
const std::vector<KeypointsLayout>& keypoint_layouts();

// One clip of a person's joints. Bones are as long as they are in most frames; hips, chest and head turn by their sides, elbows and knees
// by the plane in which they bend, everything else by the shortest turn of its bone against its parent. Which axis is up, a mirrored
// world and keypoints that are relative to the hips are found out, and told in the notes.
//   keypoints  [frames][layout.count] finite
Motion motion_of_keypoints(const KeypointsLayout& layout, const std::vector<std::vector<Point3>>& keypoints);

}  // namespace sinew
#endif
