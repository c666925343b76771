// SPDX-License-Identifier: MIT
// Fingers for the hands of a skeleton: the stages of sinew_rig_details().
#ifndef SINEW_DETAILS_HANDS_HPP
#define SINEW_DETAILS_HANDS_HPP

#include "rig/rig.hpp"

namespace sinew::rigging {

// Sets of points of a hand, each a run of the network.
constexpr uint32_t kHandSets = 4;

// Runs everything; `outputs` is a skeleton that becomes one with fingers, at the end. plan_rig() has made the plan. With a
// measuring arena neither mesh nor skeleton is read. Errors are those of sinew_rig_details().
sinew_status run_hands(const RigPlan& plan, const sinew_mesh& mesh, const Kernels& kernels, Arena& arena,
                       sinew_rig_outputs* outputs);

}  // namespace sinew::rigging
#endif
