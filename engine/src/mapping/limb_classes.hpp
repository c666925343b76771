// SPDX-License-Identifier: MIT
// sinew_limb_classes() behind its checks.
#ifndef SINEW_MAPPING_LIMB_CLASSES_HPP
#define SINEW_MAPPING_LIMB_CLASSES_HPP

#include "core/arena.hpp"
#include "sinew/map.h"

namespace sinew::mapping {

// As sinew_limb_classes(), whose structs are read and pointers checked; source and sources are both null or none is. A
// measuring arena reads the counts alone.
sinew_status find_limb_classes(const sinew_skeleton& target, const sinew_skeleton* source, const int32_t* sources,
                               Arena& arena, uint8_t* classes);

}  // namespace sinew::mapping
#endif
