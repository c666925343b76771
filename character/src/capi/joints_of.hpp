// SPDX-License-Identifier: MIT
// A caller's skeleton, checked.
#ifndef SINEW_CHARACTER_CAPI_JOINTS_OF_HPP
#define SINEW_CHARACTER_CAPI_JOINTS_OF_HPP

#include <vector>

#include "sinew/skeleton.h"
#include "sinew_formats/character.hpp"

namespace sinew {

// Throws Failure, and Error for names.
std::vector<Joint> joints_of(const sinew_skeleton* given);

}  // namespace sinew
#endif
