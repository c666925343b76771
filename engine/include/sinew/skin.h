/* SPDX-License-Identifier: MIT
 * Skinning: poses a mesh with its weights. */
#ifndef SINEW_SKIN_H
#define SINEW_SKIN_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Deforms rest positions with linear blend skinning.
 *   positions  in  [vertex_count x 3] float
 *   joints, weights in [vertex_count x influence_count], weights unorm16 (rows sum to 65535)
 *   palette    in  [joint_count x 12] row-major 3x4, pose times inverse bind per joint
 *   out        out [vertex_count x 3]; may be equal to positions
 * Float arithmetic in a fixed order (it is no part of the bit-exact result path).
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, or SINEW_ERROR_RANGE when a joint index is >= joint_count. */
SINEW_API sinew_status sinew_skin_linear(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                                         const uint16_t* weights, uint32_t influence_count, const float* palette,
                                         uint32_t joint_count, float* out);

/* The same with dual quaternion skinning (Kavan et al. 2008): rotations blend without the candy-wrapper collapse.
 *   palette  in [joint_count x 12] as above; the 3x3 part must be a rotation (uniform scale 1). */
SINEW_API sinew_status sinew_skin_dual_quaternion(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                                                  const uint16_t* weights, uint32_t influence_count,
                                                  const float* palette, uint32_t joint_count, float* out);

#ifdef __cplusplus
}
#endif
#endif
