// SPDX-License-Identifier: MIT
// A motion from keypoints of joints alone: rotations from bones and hinges.
#ifndef SINEW_FORMATS_MOTION_KEYPOINTS_HPP
#define SINEW_FORMATS_MOTION_KEYPOINTS_HPP

#include <string>
#include <vector>

#include "sinew_formats/motion.hpp"

namespace sinew {

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
