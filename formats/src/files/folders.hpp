// SPDX-License-Identifier: MIT
// The files below a folder; io.hpp has what callers see.
#ifndef SINEW_FORMATS_FILES_FOLDERS_HPP
#define SINEW_FORMATS_FILES_FOLDERS_HPP

#include <string>
#include <vector>

namespace sinew {

// Every file of a folder and of the folders below it, sorted by name within each. Hidden files and folders (.name) are
// left out, links are followed. Throws Error for what is no folder or cannot be read.
std::vector<std::string> files_below(const std::string& folder);

}  // namespace sinew
#endif
