/* SPDX-License-Identifier: MIT
 * Clips of sinew_retarget_frame(): natural ranges of joints, and measures of what is still wrong. Same bytes on every
 * platform. */
#ifndef SINEW_MOTION_CLIPS_H
#define SINEW_MOTION_CLIPS_H

#include "sinew/motion.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_MAX_MOTION_LIMBS 16 /* arms and legs of a plan; later ones are left alone */

/* Keeps knees and elbows of a clip from sinew_retarget_frame() in their natural range: bent by at most 155 degrees,
 * and backwards by at most 5 degrees or their bend at rest. The bend direction comes from toes or the feet's
 * vertices, else from the bend at rest; a joint that is straight at rest without a front has no range. The second
 * bone and its children rotate. Corrections start smoothly before the end of the range. Call it before
 * sinew_retarget_contacts(), which keeps within 155 degrees by itself. A motion of the same rig is unchanged.
 *   clip       the source's poses are only validated
 *   workspace  as for sinew_retarget_contacts(), of the same size
 * Returns what sinew_retarget_contacts() does, except SINEW_ERROR_CANCELLED. */
SINEW_API sinew_status sinew_retarget_keep_range(sinew_retarget* plan, const sinew_motion_body* target,
                                                 const sinew_motion_clip* clip, void* workspace,
                                                 size_t workspace_bytes);

/* Quality of a limb in a clip; lengths are shares of the target body's height.
 *   contact  arm: the source's hand is within 0.03 of its body; leg: the source's foot is planted in this frame and
 *            the last
 *   depth    arm: depth of the deepest point of hand or forearm inside the rest of the body; leg: depth of the foot
 *            below the floor. Beyond that of the source, or without the source's body beyond that at rest
 *   error    arm: change of the hand's distance from the body; leg: distance that the toe slides along the floor per
 *            frame */
typedef struct sinew_limb_quality {
  uint32_t joint;          /* of the target: wrist or ankle */
  uint32_t leg;            /* 1: leg, 0: arm */
  uint32_t frames;         /* of the clip */
  uint32_t deep_frames;    /* with a depth above 0.006 */
  uint32_t contact_frames; /* with a contact */
  uint32_t range_frames;   /* with elbow or knee out of its natural range by more than a degree */
  float depth;             /* mean over frames */
  float greatest_depth;
  float error; /* mean over contact frames */
  float greatest_error;
  uint32_t reserved[2]; /* 0 */
} sinew_limb_quality;

/* Measures a clip, before or after sinew_retarget_contacts(). Changes nothing.
 *   options, workspace  as in sinew_retarget_contacts(), of the same size
 *   limbs               out, [SINEW_MAX_MOTION_LIMBS]
 *   limb_count          out
 * Depth and contacts are measured for at most four arms. Returns what sinew_retarget_contacts() does; outputs are
 * untouched on failure. */
SINEW_API sinew_status sinew_retarget_measure(sinew_retarget* plan, const sinew_motion_body* source,
                                              const sinew_motion_body* target, const sinew_motion_clip* clip,
                                              const sinew_contact_options* options, void* workspace,
                                              size_t workspace_bytes, sinew_limb_quality* limbs, uint32_t* limb_count);

/* State of a limb in a frame. Numbers are never reused. */
typedef enum sinew_spot_kind {
  SINEW_SPOT_NONE = 0,    /* the rest of the spot is 0 */
  SINEW_SPOT_STANDS = 1,  /* the source's foot is planted */
  SINEW_SPOT_TOUCHES = 2, /* the source's hand touches its body */
  SINEW_SPOT_INSIDE = 3 /* hand or forearm is deeper in the body than the source's, or without its body than at rest */
} sinew_spot_kind;

/* Position of that state, for display. */
typedef struct sinew_contact_spot {
  uint32_t kind;     /* sinew_spot_kind */
  float position[3]; /* in the target's world and units: toe or ankle, vertex of the hand, deepest vertex */
  /* Share of the target's height, 0 or more: distance of the toe from its planted position in the frame before;
   * change of the hand's distance from the body; depth */
  float error;
  uint32_t reserved; /* 0 */
} sinew_contact_spot;

/* Like sinew_retarget_measure(), with the states of each frame.
 *   spots  out, [frame_count x SINEW_MAX_MOTION_LIMBS], limbs in the order of `limbs`
 * Returns what sinew_retarget_measure() does, and SINEW_ERROR_ARGUMENT if spots is null; outputs are undefined after
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
