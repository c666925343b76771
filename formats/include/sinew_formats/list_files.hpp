// SPDX-License-Identifier: MIT
// What a folder has for a purpose.
#ifndef SINEW_FORMATS_LIST_FILES_HPP
#define SINEW_FORMATS_LIST_FILES_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace sinew {

// All files that have these uses (FileUse) in a folder and those below it, sorted by path. Hidden ones (.NAME) are left out; links to folders are followed,
// each folder once. Throws Error.
std::vector<std::string> list_files(const std::string& folder, uint32_t uses);

}  // namespace sinew
#endif
