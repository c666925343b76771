// SPDX-License-Identifier: MIT
// Poses a mesh with its influences. Behind sinew_skin_linear() and sinew_skin_dual_quaternion().
#ifndef SINEW_DEFORM_SKINNING_HPP
#define SINEW_DEFORM_SKINNING_HPP

#include "sinew/sinew.h"

namespace sinew::deform {

// As in sinew.h; the caller has checked for null pointers and influence_count >= 1. Every joint index is checked before
// anything is written, those of zero weights too. No scratch, no library call.
// Returns SINEW_OK or SINEW_ERROR_RANGE.
sinew_status skin_linear(const float* positions, uint32_t vertex_count, const uint16_t* joints, const uint16_t* weights,
                         uint32_t influence_count, const float* palette, uint32_t joint_count, float* out);

// Method: L. Kavan, S. Collins, J. Zara, C. O'Sullivan, "Geometric Skinning with Approximate Dual Quaternion Blending",
// ACM TOG 27(4), 2008, algorithm 1. Quaternions are rotated to the side of the row's first one, the largest influence.
sinew_status skin_dual_quaternion(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                                  const uint16_t* weights, uint32_t influence_count, const float* palette,
                                  uint32_t joint_count, float* out);

}  // namespace sinew::deform
#endif
