// SPDX-License-Identifier: MIT
// Eyes and a jaw for the heads of a skeleton: the stages of sinew_rig_details().
#ifndef SINEW_DETAILS_FACE_HPP
#define SINEW_DETAILS_FACE_HPP

#include "details/given_skeleton.hpp"
#include "rig/rig.hpp"

namespace sinew::rigging {

// Runs everything; `outputs` is a skeleton that becomes one with a face, at the end. With a measuring arena neither mesh nor
// skeleton is read. Errors are those of sinew_rig_details().
sinew_status run_face(const RigPlan& plan, const sinew_mesh& mesh, Arena& arena, sinew_rig_outputs* outputs);

}  // namespace sinew::rigging
#endif
