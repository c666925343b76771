// SPDX-License-Identifier: MIT
// Details of a skeleton beyond its body: the stages of sinew_rig_details().
#ifndef SINEW_DETAILS_DETAILS_HPP
#define SINEW_DETAILS_DETAILS_HPP

#include "rig/rig.hpp"

namespace sinew::rigging {

struct DetailsPlan {
  uint32_t wanted = 0;  // sinew_rig_detail bits
  RigPlan hands;        // with SINEW_DETAIL_HANDS
  RigPlan shape;        // faces and props come from the shape alone
};

// Checks the caller's options and counts. Errors are those of sinew_rig_details().
sinew_status plan_details(const sinew_model* hands_model, uint32_t vertices, uint32_t faces, uint32_t corners,
                          uint32_t wanted, const sinew_rig_options* options, DetailsPlan* plan);

// Runs the wanted stages one after the other. The caller's arrays are as they were on failure. With a measuring arena neither
// mesh nor skeleton is read.
sinew_status run_details(const DetailsPlan& plan, const sinew_mesh& mesh, const Kernels& kernels, Arena& arena,
                         sinew_rig_outputs* outputs);

// One stage each: fingers, eyes and a jaw, what hands hold. `outputs` is a skeleton that becomes one with these joints, at the end. plan_rig()
// has made the plan. With a measuring arena neither mesh nor skeleton is read. Errors are those of sinew_rig_details().
sinew_status run_hands(const RigPlan& plan, const sinew_mesh& mesh, const Kernels& kernels, Arena& arena,
                       sinew_rig_outputs* outputs);
sinew_status run_face(const RigPlan& plan, const sinew_mesh& mesh, Arena& arena, sinew_rig_outputs* outputs);
sinew_status run_props(const RigPlan& plan, const sinew_mesh& mesh, Arena& arena, sinew_rig_outputs* outputs);

}  // namespace sinew::rigging
#endif
