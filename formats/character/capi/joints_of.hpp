// SPDX-License-Identifier: MIT
// A caller's skeleton, checked.
#ifndef SINEW_CHARACTER_CAPI_JOINTS_OF_HPP
#define SINEW_CHARACTER_CAPI_JOINTS_OF_HPP

#include <vector>

#include "sinew/types.h"
#include "sinew_formats/character.hpp"

namespace sinew {

// Throws Failure, and Error for names.
std::vector<Joint> joints_of(const sinew_skeleton& skeleton, const char* const* names);

}  // namespace sinew
#endif
