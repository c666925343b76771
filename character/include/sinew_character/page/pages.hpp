// SPDX-License-Identifier: MIT
// Pages of one file each: on a folder that was bound, and on files that were checked.
#ifndef SINEW_CHARACTER_PAGE_PAGES_HPP
#define SINEW_CHARACTER_PAGE_PAGES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/check/check_output.hpp"
#include "sinew_character/draw/image.hpp"

namespace sinew {

// A page on the files that one run bound: a row each, with a picture of the weights.
struct BoundRow {
  std::string name;
  size_t vertices = 0, joints = 0, joints_used = 0;
  double seconds = 0;
  std::string doubts;  // one line; empty: none
  std::vector<std::string> notes;
  std::string error;         // one line; not empty: the file failed and the numbers mean nothing
  std::vector<uint8_t> png;  // empty: no picture
};

// One page that needs nothing else. `folder` and `method` go into its head.
std::string bind_html(const std::string& folder, const std::string& method, const std::vector<BoundRow>& rows);

// The finding's vertices ringed, or its joint, in the pose or the frame in which it shows; colors are the joints', by weight.
Image finding_picture(const CheckedFile& file, const RigFinding& finding);

// One page that needs nothing else. Of a file's findings the first 40 have a picture.
std::string check_html(const std::vector<CheckedFile>& files);

}  // namespace sinew
#endif
