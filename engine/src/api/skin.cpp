// SPDX-License-Identifier: MIT
// The C API: argument checks of the skinning functions.
#include "sinew/skin.h"

#include "deform/skinning.hpp"

extern "C" {

sinew_status sinew_skin_linear(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                               const uint16_t* weights, uint32_t influence_count, const float* palette,
                               uint32_t joint_count, float* out) {
  if (positions == nullptr || joints == nullptr || weights == nullptr || palette == nullptr || out == nullptr ||
      influence_count == 0) {
    return SINEW_ERROR_ARGUMENT;
  }
  return sinew::deform::skin_linear(positions, vertex_count, joints, weights, influence_count, palette, joint_count,
                                    out);
}

sinew_status sinew_skin_dual_quaternion(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                                        const uint16_t* weights, uint32_t influence_count, const float* palette,
                                        uint32_t joint_count, float* out) {
  if (positions == nullptr || joints == nullptr || weights == nullptr || palette == nullptr || out == nullptr ||
      influence_count == 0) {
    return SINEW_ERROR_ARGUMENT;
  }
  return sinew::deform::skin_dual_quaternion(positions, vertex_count, joints, weights, influence_count, palette,
                                             joint_count, out);
}

}  // extern "C"
