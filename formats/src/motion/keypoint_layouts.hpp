// SPDX-License-Identifier: MIT
// Layouts of keypoints: which columns are which joints, and how well given keypoints are a body in one of them.
#ifndef SINEW_FORMATS_MOTION_KEYPOINT_LAYOUTS_HPP
#define SINEW_FORMATS_MOTION_KEYPOINT_LAYOUTS_HPP

#include <string>
#include <vector>

#include "sinew_formats/keypoints_stream.hpp"

namespace sinew {

// All joints of a layout, both sides, and the columns of each.
struct LayoutColumns {
  std::vector<std::string> names;
  std::vector<std::vector<size_t>> of;

  explicit LayoutColumns(const KeypointsLayout& layout);
  // Where the joints are in one row of keypoints. [names]
  std::vector<Point3> joints_of(const std::vector<Point3>& row) const;
};

// How unlike a body the keypoints are when they are read in a layout: 0 where bones keep their lengths, both sides are alike, proportions are a person's,
// and the head is on the other side of the hips than the feet. Captures of people have 0.1 to 0.5.
//   keypoints  [frames][layout.count], at least one frame, any unit
double layout_misfit(const KeypointsLayout& layout, const std::vector<std::vector<Point3>>& keypoints);

// The layout of that many keypoints in which they are a body; null where none or more than one fits, then `misfits` names each with how badly
// it fits, or is empty when no layout has so many.
const KeypointsLayout* recognize_layout(const std::vector<std::vector<Point3>>& keypoints, std::string* misfits);

}  // namespace sinew
#endif
