// SPDX-License-Identifier: MIT
// Retargeting by reference points on the mesh, the published method: every triangle of the posed target proposes a
// position for a joint: its own position plus the vector from the same triangle to the joint in the source, scaled by
// the lengths of the bones between. The room `published` defines the functions.
#ifndef SINEW_MOTION_REFERENCE_POINTS_HPP
#define SINEW_MOTION_REFERENCE_POINTS_HPP

#include "motion/clip_scene.hpp"
#include "sinew/published.h"

namespace sinew::motion {

// The options of the interface, checked.
struct ReferenceOptions {
  uint32_t area_power = 3;
  bool own_limb = false, legs = false, head = false, torso = false, source_points = false;
  bool as_drawn = false;  // one sum over all parts of the body, and nothing pushed out
  // Capsules are a guess (ours): they push joints away from the body, straight out, and do no more.
  bool outwards = false;
  double falloff = static_cast<double>(0.05f);  // share of the source's height, as a caller says it; 0 = none
  double least_cosine = 1e-5;
};
// Also reads progress into `progress`. Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_VERSION.
sinew_status read_reference_options(const sinew_reference_options* options, ReferenceOptions* out, Progress* progress);

// Behind sinew_retarget_reference_points(); the caller has checked pointers and the bodies.
size_t measure_reference_points(uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles);
// source: or null, then capsules represent both bodies.
sinew_status run_reference_points(sinew_retarget* plan, const sinew_motion_body* source,
                                  const sinew_motion_body& target, const ClipInputs& inputs,
                                  const ReferenceOptions& options, Arena& arena);

}  // namespace sinew::motion
#endif
