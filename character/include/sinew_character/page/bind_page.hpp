// SPDX-License-Identifier: MIT
// A page on the files that one run bound: a row each, with a picture of the weights.
#ifndef SINEW_CHARACTER_BIND_PAGE_HPP
#define SINEW_CHARACTER_BIND_PAGE_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sinew {

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

}  // namespace sinew
#endif
