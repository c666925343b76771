// SPDX-License-Identifier: MIT
// sinew_joint_classes() behind its checks.
#ifndef SINEW_NAMES_JOINT_VERDICTS_HPP
#define SINEW_NAMES_JOINT_VERDICTS_HPP

#include "core/arena.hpp"
#include "sinew/names.h"

namespace sinew::names {

// `verdicts` is null where the arena measures. SINEW_ERROR_WORKSPACE and those of NamedJoints::build().
sinew_status find_joint_verdicts(const sinew_skeleton& joints, const uint8_t* follows, Arena& arena,
                                 sinew_joint_verdicts* verdicts);

}  // namespace sinew::names
#endif
