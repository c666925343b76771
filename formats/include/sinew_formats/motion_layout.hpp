// SPDX-License-Identifier: MIT
// Which files a layout of read_motion() means something for.
#ifndef SINEW_FORMATS_MOTION_LAYOUT_HPP
#define SINEW_FORMATS_MOTION_LAYOUT_HPP

#include <string>

namespace sinew {

// Whether a file's joints are places alone. check_layout() throws Error where they say themselves which they are.
bool takes_layout(const std::string& path);
void check_layout(const std::string& path);

}  // namespace sinew
#endif
