// SPDX-License-Identifier: MIT
// Joint names of conventions: the one table of class, side and index to names.
#ifndef SINEW_NAMES_STANDARD_NAMES_HPP
#define SINEW_NAMES_STANDARD_NAMES_HPP

#include <stdint.h>

#include "sinew/names.h"

namespace sinew::names {

const char* naming_text(uint32_t naming);  // null behind the last

// As sinew_joint_standard_name(), whose arguments are checked. False where the convention has no such joint.
bool standard_name(uint32_t naming, uint32_t joint_class, int32_t side, uint32_t index,
                   char name[SINEW_JOINT_NAME_BYTES]);

}  // namespace sinew::names
#endif
