// SPDX-License-Identifier: MIT
// Joints for what the hands of a skeleton hold: the stages of sinew_rig_details().
#ifndef SINEW_DETAILS_PROPS_HPP
#define SINEW_DETAILS_PROPS_HPP

#include "details/given_skeleton.hpp"
#include "rig/rig.hpp"

namespace sinew::rigging {

// Runs everything; `outputs` is a skeleton that becomes one with props, at the end. With a measuring arena neither mesh nor
// skeleton is read. Errors are those of sinew_rig_details().
sinew_status run_props(const RigPlan& plan, const sinew_mesh& mesh, Arena& arena, sinew_rig_outputs* outputs);

}  // namespace sinew::rigging
#endif
