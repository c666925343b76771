/* SPDX-License-Identifier: MIT
 * Motion as it comes: one frame of a capture or a game in, one frame of the target out, without delay. Contacts with the floor are
 * kept by what was before, and so are hands on the own body. Same bytes on every platform. */
#ifndef SINEW_MOTION_STREAM_H
#define SINEW_MOTION_STREAM_H

#include "sinew/motion.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Start from SINEW_INIT(sinew_retarget_stream_options). Later versions add members at the end, as in sinew_retarget_options. */
typedef struct sinew_retarget_stream_options {
  uint32_t struct_size; /* sizeof(sinew_retarget_stream_options) */
  float fps;            /* frames a second; 0 = 30 */
  float ground;         /* height of a standing ankle, as sinew_retarget_ground() has it */
  uint32_t
      has_ground; /* 0: the source's own at rest; where that stands on no floor, as low as its feet have rested so far */
  uint32_t
      without; /* bits of sinew_without: SINEW_WITHOUT_CONTACTS, frames as sinew_retarget_frame() has them, in their
                             * range; SINEW_WITHOUT_RANGE, see sinew_retarget_keep_range() */
  uint32_t reserved;        /* 0 */
  const sinew_floor* floor; /* of the target, borrowed as the body is; null: level */
  /* The body that moves the source, of the same vertices and triangles as the target's (its `triangles` are not looked at), borrowed as
   * that is; null: nobody knows what hands touch, and arms may be in the target's body as deep as at rest */
  const sinew_motion_body* source;
} sinew_retarget_stream_options;

/* A stream; it lies in the caller's memory, holds pointers into it and must not be moved. */
typedef struct sinew_retarget_stream sinew_retarget_stream;

/* Bytes sinew_retarget_stream_create() needs: for the stream, its plan and all frames. A pure function of its arguments: the same
 * on every host with pointers of one size.
 *   body_vertices   of the body; 0: none
 *   body_triangles  of the body; 0 where there are none, and hands then know nothing of it
 *   size_bytes      out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_retarget_stream_workspace_size(uint32_t source_joints, uint32_t target_joints,
                                                            uint32_t body_vertices, uint32_t body_triangles,
                                                            size_t* size_bytes);

/* Makes a stream with a plan of its own.
 *   source .. plan_options  as in sinew_retarget_create()
 *   body     the target's, whose skin is to be on the floor and which hands are to touch as the source's do; borrowed until the last
 *            call with the stream. Without triangles hands know nothing of it. null: joints are on the floor as they are at rest
 *   options  null = all defaults
 *   memory   64-byte aligned, size from sinew_retarget_stream_workspace_size(); the stream's until the last call with it
 *   stream   out; untouched on failure
 * Returns what sinew_retarget_create() does, of bodies what sinew_retarget_contacts() does, and of a floor SINEW_ERROR_ARGUMENT,
 * SINEW_ERROR_COUNT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_stream_create(const sinew_skeleton* source, const sinew_skeleton* target,
                                                    const int32_t* map, const uint8_t* target_classes,
                                                    const sinew_retarget_options* plan_options,
                                                    const sinew_motion_body* body,
                                                    const sinew_retarget_stream_options* options, void* memory,
                                                    size_t memory_bytes, sinew_retarget_stream** stream);

/* The next frame: as sinew_retarget_frame(), knees and elbows in their range, then feet, hands, knees, elbows, seat and chest on the
 * floor, and hands on the body and out of it, as in sinew_retarget_contacts(). What comes to stand stays where it is then, in place of
 * the mean of the frames to come; hands come out of the body at once, and what they were moved by fades. Arrays as in sinew_retarget_frame(); one thread at a time.
 * Returns SINEW_OK, or with outputs untouched and the frame forgotten SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_stream_frame(sinew_retarget_stream* stream, const float* rotations,
                                                   const float* translations, float* out_rotations,
                                                   float* out_translations);

/* Forgets the frames before: the next one is the first. Returns SINEW_OK or SINEW_ERROR_ARGUMENT. */
SINEW_API sinew_status sinew_retarget_stream_restart(sinew_retarget_stream* stream);

#ifdef __cplusplus
}
#endif
#endif
