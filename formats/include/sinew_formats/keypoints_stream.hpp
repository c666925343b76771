// SPDX-License-Identifier: MIT
// Converts streamed keypoints of a camera or a capture to rotations of a person's joints, as input for
// sinew/motion_stream.h.
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
  //   first   [frames][keypoints of the layout] of a moving person, any unit. They determine the bone lengths, the up axis, whether the world is mirrored and whether keypoints are relative to the hips. One frame is enough; a second or two are better
  // Throws Error.
  KeypointsStream(const std::string& layout, const std::vector<std::vector<Point3>>& first);
  KeypointsStream(KeypointsStream&&) noexcept;
  ~KeypointsStream();

  // The joints at rest, y up, with notes about the detected conventions, and `first` as a clip at the layout's frame
  // rate.
  const Motion& person() const;
  // Returns rotations and translations of person()'s joints in the frame of these keypoints, independent of other
  // frames. Throws Error.
  MotionFrame next(const std::vector<Point3>& keypoints) const;

 private:
  void check(const std::vector<Point3>& row) const;

  const KeypointsLayout* layout_ = nullptr;
  std::unique_ptr<KeypointsSolver> solver_;
};

// Assignment of the values in a row to joints.
struct KeypointsLayout {
  const char* name;  // "coco17"
  size_t count;      // keypoints in a row
  double fps;        // default frame rate
  struct Joint {
    const char* name;             // of person_joints(); a "left" name is for both sides
    std::vector<size_t> columns;  // the joint is their mean; for a "left" name those of the left side
    std::vector<size_t> right = {};
  };
  std::vector<Joint> joints;
};
const std::vector<KeypointsLayout>& keypoint_layouts();

// Makes one clip of a person's joints. Bones have their median length; hips, chest and head are oriented by their
// sides, elbows and knees by their bending plane, other joints by the shortest rotation of the bone relative to its
// parent. The up axis, a mirrored world and keypoints relative to the hips are detected and reported in the notes.
//   keypoints  [frames][layout.count] finite
Motion motion_of_keypoints(const KeypointsLayout& layout, const std::vector<std::vector<Point3>>& keypoints);

}  // namespace sinew
#endif
