// SPDX-License-Identifier: MIT
// The C API: argument checks of the skinning functions.
#include "sinew/skin.h"

#include "deform/skinning.hpp"

static bool are_given(const float* positions, const sinew_skin* skin, const float* palette, const float* out) {
  return positions != nullptr && skin != nullptr && skin->joint_indices != nullptr && skin->weights != nullptr &&
         skin->influence_count > 0 && skin->weight_format == SINEW_WEIGHT_UNORM16 && palette != nullptr &&
         out != nullptr;
}

extern "C" {

sinew_status sinew_skin_linear(const float* positions, uint32_t vertex_count, const sinew_skin* skin,
                               const float* palette, uint32_t joint_count, float* out) {
  if (!are_given(positions, skin, palette, out)) return SINEW_ERROR_ARGUMENT;
  return sinew::deform::skin_linear(positions, vertex_count, skin->joint_indices,
                                    static_cast<const uint16_t*>(skin->weights), skin->influence_count, palette,
                                    joint_count, out);
}

sinew_status sinew_skin_dual_quaternion(const float* positions, uint32_t vertex_count, const sinew_skin* skin,
                                        const float* palette, uint32_t joint_count, float* out) {
  if (!are_given(positions, skin, palette, out)) return SINEW_ERROR_ARGUMENT;
  return sinew::deform::skin_dual_quaternion(positions, vertex_count, skin->joint_indices,
                                             static_cast<const uint16_t*>(skin->weights), skin->influence_count,
                                             palette, joint_count, out);
}

}  // extern "C"
