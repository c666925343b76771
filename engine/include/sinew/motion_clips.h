/* SPDX-License-Identifier: MIT
 * Whole clips of sinew/motion.h, after they were copied: natural ranges of joints, and what is left to be mended. Same bytes
 * on every platform. */
#ifndef SINEW_MOTION_CLIPS_H
#define SINEW_MOTION_CLIPS_H

#include "sinew/motion.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_MAX_MOTION_LIMBS 16 /* arms and legs of a plan; later ones are left alone */

/* Brings knees and elbows of a clip that sinew_retarget_frame() made into their natural range: bent by no more than 155 degrees,
 * and to the other side by no more than 5 or what they are at rest. Toes or the feet's vertices say to which side they bend,
 * else the bends at rest do; what is straight at rest and has no front has no range. The second bone rotates, and all below
 * it. Corrections start gently at the end of the range, so that nothing pops. Before contacts are mended, which keep within 155
 * degrees by themselves. A motion of this very rig is left as it is.
 *   clip       the source's poses are checked and no more
 *   workspace  as for sinew_retarget_contacts(), of the same size
 * Returns what sinew_retarget_contacts() does, but is not cancelled. */
SINEW_API sinew_status sinew_retarget_keep_range(sinew_retarget* plan, const sinew_motion_body* target,
                                                 const sinew_motion_clip* clip, void* workspace,
                                                 size_t workspace_bytes);

/* What is left to be mended in a limb of a clip, in shares of the target body's height.
 *   contact  an arm's: the source's hand is within 0.03 of its body; a leg's: the source's foot stands, this frame and the last
 *   depth    an arm's: of the deepest point of hand or forearm under the rest of the body; a leg's: of the lowest of the foot
 *            under the floor. Beyond the source's, or without the source's body beyond that at rest
 *   error    an arm's: change of the hand's distance from the body; a leg's: distance of the toe along the floor in a frame */
typedef struct sinew_limb_quality {
  uint32_t joint;          /* of the target: wrist or ankle */
  uint32_t leg;            /* 1: leg, 0: arm */
  uint32_t frames;         /* of the clip */
  uint32_t deep_frames;    /* with a depth above 0.006 */
  uint32_t contact_frames; /* with a contact */
  uint32_t range_frames;   /* elbow or knee is out of its natural range by more than a degree */
  float depth;             /* mean over frames */
  float greatest_depth;
  float error; /* mean over contact frames */
  float greatest_error;
  uint32_t reserved[2]; /* 0 */
} sinew_limb_quality;

/* Measures a clip, before or after its contacts were mended; changes nothing.
 *   options, workspace  as in sinew_retarget_contacts(), of the same size
 *   limbs               out, [SINEW_MAX_MOTION_LIMBS]
 *   limb_count          out
 * Of four arms at most depth and contacts are looked at. Returns what sinew_retarget_contacts() does; outputs are
 * untouched on failure. */
SINEW_API sinew_status sinew_retarget_measure(sinew_retarget* plan, const sinew_motion_body* source,
                                              const sinew_motion_body* target, const sinew_motion_clip* clip,
                                              const sinew_contact_options* options, void* workspace,
                                              size_t workspace_bytes, sinew_limb_quality* limbs, uint32_t* limb_count);

/* What a limb does in a frame. Numbers are never reused. */
typedef enum sinew_spot_kind {
  SINEW_SPOT_NONE = 0,    /* the rest of the spot is 0 */
  SINEW_SPOT_STANDS = 1,  /* the source's foot stands */
  SINEW_SPOT_TOUCHES = 2, /* the source's hand touches its body */
  SINEW_SPOT_INSIDE = 3 /* hand or forearm is deeper in the body than the source's, or without its body than at rest */
} sinew_spot_kind;

/* Where that is, to be shown. */
typedef struct sinew_contact_spot {
  uint32_t kind;     /* sinew_spot_kind */
  float position[3]; /* in the target's world and units: toe or ankle, vertex of the hand, deepest vertex */
  /* Share of the target's height, 0 or more: distance of the toe from where it stood in the frame before, if it stood; change
   * of the hand's distance from the body; depth */
  float error;
  uint32_t reserved; /* 0 */
} sinew_contact_spot;

/* As sinew_retarget_measure(), and frame by frame where that is.
 *   spots  out, [frame_count x SINEW_MAX_MOTION_LIMBS], limbs in the order of `limbs`
 * Returns what sinew_retarget_measure() does, and SINEW_ERROR_ARGUMENT where spots is null; undefined after
 * SINEW_ERROR_CANCELLED and SINEW_ERROR_NOT_FINITE, else untouched on failure. */
SINEW_API sinew_status sinew_retarget_spots(sinew_retarget* plan, const sinew_motion_body* source,
                                            const sinew_motion_body* target, const sinew_motion_clip* clip,
                                            const sinew_contact_options* options, void* workspace,
                                            size_t workspace_bytes, sinew_limb_quality* limbs, uint32_t* limb_count,
                                            sinew_contact_spot* spots);

#ifdef __cplusplus
}
#endif
#endif
