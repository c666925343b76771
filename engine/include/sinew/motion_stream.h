/* SPDX-License-Identifier: MIT
 * Streaming retargeting: one frame of a capture or a game in, one frame of the target out, without delay. Contacts
 * with the floor and of hands with the body are kept from past frames only. Same bytes on every platform. */
#ifndef SINEW_MOTION_STREAM_H
#define SINEW_MOTION_STREAM_H

#include "sinew/motion.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Start from SINEW_INIT(sinew_retarget_stream_options). Later versions add members at the end, as in sinew_retarget_options. */
typedef struct sinew_retarget_stream_options {
  uint32_t struct_size; /* sizeof(sinew_retarget_stream_options) */
  float fps;            /* frames per second; 0 = 30 */
  float ground;         /* height of a standing ankle, as from sinew_retarget_ground() */
  /* 1: `ground` is set; 0: that of the source at rest, or if it does not stand, the lowest height of its feet so far */
  uint32_t has_ground;
  /* Bits of sinew_without: SINEW_WITHOUT_CONTACTS, frames of sinew_retarget_frame() in their natural range;
   * SINEW_WITHOUT_RANGE, see sinew_retarget_keep_range() */
  uint32_t without;
  uint32_t reserved;        /* 0 */
  const sinew_floor* floor; /* floor of the target, borrowed like the body; null: level */
  /* The source's body, with the same vertices and triangles as the target's (its `triangles` are ignored), borrowed
   * like it; null: hands keep no contacts with the body, and arms may be as deep in the target's body as at rest */
  const sinew_motion_body* source;
} sinew_retarget_stream_options;

/* A stream in the caller's memory. It holds pointers into that memory, which must not be moved. */
typedef struct sinew_retarget_stream sinew_retarget_stream;

/* Returns the bytes that sinew_retarget_stream_create() needs for the stream and its plan. A pure function of its
 * arguments: the same on every host with the same pointer size.
 *   body_vertices   of the body; 0: none
 *   body_triangles  of the body; 0: none, and hands then keep no contacts with it
 *   size_bytes      out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_retarget_stream_workspace_size(uint32_t source_joints, uint32_t target_joints,
                                                            uint32_t body_vertices, uint32_t body_triangles,
                                                            size_t* size_bytes);

/* Creates a stream with its own plan.
 *   source .. plan_options  as in sinew_retarget_create()
 *   body     the target's body, for contacts of its skin with the floor and with the hands; borrowed until the last
 *            call with the stream. Without triangles hands keep no contacts with it. null: joints keep the floor
 *            distance of the rest pose
 *   options  null = all defaults
 *   memory   64-byte aligned, size from sinew_retarget_stream_workspace_size(); in use until the last call with the
 *            stream
 *   stream   out; untouched on failure
 * Returns what sinew_retarget_create() does, for bodies what sinew_retarget_contacts() does, and for a floor
 * SINEW_ERROR_ARGUMENT, SINEW_ERROR_COUNT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_stream_create(const sinew_skeleton* source, const sinew_skeleton* target,
                                                    const int32_t* map, const uint8_t* target_classes,
                                                    const sinew_retarget_options* plan_options,
                                                    const sinew_motion_body* body,
                                                    const sinew_retarget_stream_options* options, void* memory,
                                                    size_t memory_bytes, sinew_retarget_stream** stream);

/* Retargets the next frame: sinew_retarget_frame(), then knees and elbows in their natural range, then contacts with
 * the floor and of hands with the body as in sinew_retarget_contacts(). A planted foot stays at its first position,
 * not at the mean of its later frames; hands leave the body at once, and their correction fades out. Arrays as in
 * sinew_retarget_frame(); one thread at a time.
 * Returns SINEW_OK, or with outputs untouched and the frame ignored SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_stream_frame(sinew_retarget_stream* stream, const float* rotations,
                                                   const float* translations, float* out_rotations,
                                                   float* out_translations);

/* Resets the stream: the next frame is its first. Returns SINEW_OK or SINEW_ERROR_ARGUMENT. */
SINEW_API sinew_status sinew_retarget_stream_restart(sinew_retarget_stream* stream);

#ifdef __cplusplus
}
#endif
#endif
