/* SPDX-License-Identifier: MIT
 * Skins: weights as calls take them, and linear and dual quaternion skinning. */
#ifndef SINEW_SKIN_H
#define SINEW_SKIN_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_weight_format {
  SINEW_WEIGHT_UNORM16 = 0, /* uint16_t, a row sums to exactly 65535 */
  SINEW_WEIGHT_UNORM8 = 1,  /* uint8_t, a row sums to exactly 255 */
  SINEW_WEIGHT_FLOAT = 2    /* float, unorm16 / 65535 */
} sinew_weight_format;

/* Weights of a mesh, as sinew_bind() gives them, borrowed for the duration of a call. This struct never changes. A
 * vertex whose row is all 0 does not move; sinew_transfer() treats its weights as unknown. */
typedef struct sinew_skin {
  const uint16_t* joint_indices; /* [vertex_count x influence_count] */
  const void* weights;           /* [vertex_count x influence_count] in weight_format; each row in descending order */
  uint32_t influence_count;      /* 1 .. SINEW_MAX_INFLUENCES */
  uint32_t weight_format;        /* sinew_weight_format. sinew_transfer() takes all formats, every other call only
                                  * SINEW_WEIGHT_UNORM16 */
} sinew_skin;

/* Deforms rest positions with linear blend skinning.
 *   positions  in  [vertex_count x 3] float
 *   palette    in  [joint_count x 12] row-major 3x4, pose times inverse bind per joint
 *   out        out [vertex_count x 3]; may be equal to positions
 * Float arithmetic in a fixed order (not part of the bit-exact results).
 * Returns SINEW_OK, or
 *   SINEW_ERROR_ARGUMENT  a pointer is null, influence_count is 0 or weight_format is not SINEW_WEIGHT_UNORM16
 *   SINEW_ERROR_RANGE     a joint index is >= joint_count */
SINEW_API sinew_status sinew_skin_linear(const float* positions, uint32_t vertex_count, const sinew_skin* skin,
                                         const float* palette, uint32_t joint_count, float* out);

/* The same as sinew_skin_linear() with dual quaternion skinning (Kavan et al. 2008): rotations blend without the
 * candy-wrapper collapse.
 *   palette  in [joint_count x 12] as above; the 3x3 part must be a rotation (uniform scale 1). */
SINEW_API sinew_status sinew_skin_dual_quaternion(const float* positions, uint32_t vertex_count, const sinew_skin* skin,
                                                  const float* palette, uint32_t joint_count, float* out);

#ifdef __cplusplus
}
#endif
#endif
