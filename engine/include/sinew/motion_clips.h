/* SPDX-License-Identifier: MIT
 * Whole clips of sinew/motion.h, after they were copied: natural ranges of joints, the published retargeting by reference points, and
 * what is left to be mended. Same bytes on every platform. */
#ifndef SINEW_MOTION_CLIPS_H
#define SINEW_MOTION_CLIPS_H

#include "sinew/motion.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_MAX_MOTION_LIMBS 16 /* arms and legs of a plan; later ones are left alone */

/* Brings knees and elbows of a clip that sinew_retarget_frame() made into their natural range: bent by no more than 155 degrees,
 * and to the other side by no more than 5 or what they are at rest. To which side they bend toes or the feet's vertices say, else
 * the bends at rest; what is straight at rest without a front has no range. The second bone turns, with all that hangs on
 * it; the less the nearer it is to its range, so that nothing pops. Before contacts are mended, which keep within 155
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
 *   error    an arm's: change of the hand's distance from the body; a leg's: way of the toe along the floor in a frame */
typedef struct sinew_limb_measure {
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
} sinew_limb_measure;

/* Measures a clip, before or after its contacts were mended; changes nothing.
 *   options, workspace  as in sinew_retarget_contacts(), of the same size
 *   limbs               out, [SINEW_MAX_MOTION_LIMBS]
 *   limb_count          out
 * Of four arms at most depth and contacts are looked at. Returns what sinew_retarget_contacts() does; outputs are
 * untouched on failure. */
SINEW_API sinew_status sinew_retarget_measure(sinew_retarget* plan, const sinew_motion_body* source,
                                              const sinew_motion_body* target, const sinew_motion_clip* clip,
                                              const sinew_contact_options* options, void* workspace,
                                              size_t workspace_bytes, sinew_limb_measure* limbs, uint32_t* limb_count);

/* What a limb does in a frame. Numbers are never reused. */
typedef enum sinew_spot_kind {
  SINEW_SPOT_NONE = 0,    /* the rest of the spot is 0 */
  SINEW_SPOT_STANDS = 1,  /* the source's foot stands */
  SINEW_SPOT_TOUCHES = 2, /* the source's hand touches its body */
  SINEW_SPOT_INSIDE =
      3 /* hand or forearm is in the body, by more than the source's, or without its body than at rest */
} sinew_spot_kind;

/* Where that is, to be shown. */
typedef struct sinew_contact_spot {
  uint32_t kind;  /* sinew_spot_kind */
  float place[3]; /* in the target's world and units: toe or ankle, vertex of the hand, deepest vertex */
  float error; /* share of the target's height: way of the toe since the frame before where it stood then, change of the
                      * hand's distance from the body, depth; 0 or more */
  uint32_t reserved; /* 0 */
} sinew_contact_spot;

/* As sinew_retarget_measure(), and frame by frame where that is.
 *   spots  out, [frame_count x SINEW_MAX_MOTION_LIMBS], limbs in the order of `limbs`
 * Returns what sinew_retarget_measure() does, and SINEW_ERROR_ARGUMENT where spots is null; undefined after
 * SINEW_ERROR_CANCELLED and SINEW_ERROR_NOT_FINITE, else untouched on failure. */
SINEW_API sinew_status sinew_retarget_spots(sinew_retarget* plan, const sinew_motion_body* source,
                                            const sinew_motion_body* target, const sinew_motion_clip* clip,
                                            const sinew_contact_options* options, void* workspace,
                                            size_t workspace_bytes, sinew_limb_measure* limbs, uint32_t* limb_count,
                                            sinew_contact_spot* spots);

#define SINEW_NO_AREA 0xFFFFFFFFu /* sinew_reference_options.area_power: 0, which as a number asks for the default */

/* Start from sinew_reference_options_init(). Later versions add members at the end, as in sinew_retarget_options. Legs are
 * left as they are copied unless asked for, because feet leave the floor by it. */
typedef struct sinew_reference_options {
  uint32_t struct_size;    /* sizeof(sinew_reference_options) */
  uint32_t area_power;     /* n, 1 .. 4, or SINEW_NO_AREA for 0; 0 = 3 */
  uint32_t no_own_limb;    /* 1: triangles of the limb itself have no say */
  uint32_t legs;           /* 1: legs as well */
  float falloff;           /* 0 = none; else d: influence also falls by exp(-(distance / (d * source's height))^2) */
  float least_cosine;      /* eps, up to 1; 0 = 1e-5 */
  sinew_progress progress; /* or null */
  void* progress_user;
} sinew_reference_options;

static inline sinew_reference_options sinew_reference_options_init(void) {
  sinew_reference_options options;
  memset(&options, 0, sizeof options);
  options.struct_size = sizeof options;
  return options;
}

/* Bytes sinew_retarget_reference_points() needs. 0 bytes on failure.
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, or SINEW_ERROR_COUNT where that is more than memory can hold. */
SINEW_API sinew_status sinew_retarget_reference_points_size(const sinew_retarget* plan, const sinew_motion_body* target,
                                                            size_t* size_bytes);

/* The published retargeting by reference points on the mesh, for comparison; sinew_retarget_contacts() is better. Changes arms
 * of frames that sinew_retarget_frame() made; frames do not know of each other, so that a clip may be one live frame.
 *   Reference points are the middles c of the triangles. In the source v = joint - c for elbows and wrists; a triangle's
 * influence is (area / mean area)^n max(|cos(v, normal)|, eps), of sum 1. In the target the joint goes to the sum of
 * influence (c' + v t' / t): t and t' are the lengths of source's and target's bones as seen along v, summed over the way
 * through the skeleton from the joint nearest to c at rest; the ratio of heights where t is nothing. Arms bend to
 * elbow and wrist with bones of their length; all else stays as it was copied.
 *   source  the body that moved, of the same vertices and triangles as the target's (its `triangles` are not looked at)
 *   clip    `ground` is not looked at
 * Returns what sinew_retarget_contacts() does; SINEW_ERROR_ARGUMENT also for options out of their range. */
SINEW_API sinew_status sinew_retarget_reference_points(sinew_retarget* plan, const sinew_motion_body* source,
                                                       const sinew_motion_body* target, const sinew_motion_clip* clip,
                                                       const sinew_reference_options* options, void* workspace,
                                                       size_t workspace_bytes);

#ifdef __cplusplus
}
#endif
#endif
