/* SPDX-License-Identifier: MIT
 * Binding: predicts skin weights of a mesh for a skeleton. */
#ifndef SINEW_BIND_H
#define SINEW_BIND_H

#include "sinew/model.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_method {
  SINEW_METHOD_MODEL = 0, /* the network of the model */
  SINEW_METHOD_HEAT = 1   /* heat fields alone; model may be null */
} sinew_method;

typedef enum sinew_weight_format {
  SINEW_WEIGHT_UNORM16 = 0, /* uint16_t, a row sums to exactly 65535 */
  SINEW_WEIGHT_UNORM8 = 1,  /* uint8_t, a row sums to exactly 255 */
  SINEW_WEIGHT_FLOAT = 2    /* float, unorm16 / 65535 */
} sinew_weight_format;

/* Whether a connected component moves as one piece. Artists bind the same geometry both ways. */
typedef enum sinew_rigid_parts {
  SINEW_RIGID_PARTS_AUTO = 0,   /* as the model or the heat field says */
  SINEW_RIGID_PARTS_ALWAYS = 1, /* every component gets one joint: the one with most of its weight */
  SINEW_RIGID_PARTS_NEVER = 2   /* components that the model alone makes rigid (19/20 of the weight on one joint, but
                                 * not in the heat field) get the heat field's weights */
} sinew_rigid_parts;

/* All zero means defaults. */
typedef struct sinew_options {
  uint32_t version;         /* 0 */
  uint32_t method;          /* sinew_method */
  uint32_t influence_count; /* 1..12 influences a vertex keeps; 0 = 4 */
  uint32_t candidate_count; /* 1..16 joints a vertex is scored against; 0 = the model's own. Heat scores all joints. A
                             * model whose layers are tied to its own count refuses another (SINEW_ERROR_ARGUMENT) */
  uint32_t grid_size;       /* 16..128 voxel cells along the longest side; 0 = the model's own. Heat needs no grid */
  uint32_t up_axis;         /* 0 = Y is up, 1 = Z is up */
  uint32_t weight_format;   /* sinew_weight_format */
  uint32_t symmetric;       /* 1: vertices that are each other's mirror image get mirrored rows, to the last bit (on the
                             * mirror plane itself up to the one step that an odd sum leaves over). The plane is x = c,
                             * found by itself; a character that has none stays as it is, see symmetric_vertices */
  uint32_t rigid_parts;     /* sinew_rigid_parts; locked vertices and hints have the last word */
  uint32_t softness_percent; /* 25..400: how softly the model's weights blend, 200 twice as softly; 0 = 100. Not for
                              * SINEW_METHOD_HEAT */
  const uint8_t* locked;     /* [vertex_count] non-zero: this vertex keeps the row already in the output; or null */
  sinew_progress progress;   /* or null */
  void* progress_user;
  /* [vertex_count] non-zero: a hint. The vertex keeps the row already in the output, as if it were locked, and the row
   * steers its surroundings: what was given minus what was predicted is spread over the connected part of the mesh,
   * weaker with distance. Or null. Given to sinew_bind_workspace_size() too: it asks for more then. */
  const uint8_t* hints;
  /* [vertex_count] out: how sure the strongest joint is the one an artist would choose, 0..255 = 0..100 %. The
   * strongest joint's share of the prediction, through the model's table of measured shares of hits if it has one
   * (sinew_model::confidence_count). 255 for locked and hinted vertices. Or null. */
  uint8_t* confidence;
  /* out, with `symmetric`: how many vertices have a mirror image (themselves, on the plane); 0: no mirror plane was
   * found and symmetric did nothing. Or null. */
  uint32_t* symmetric_vertices;
  uint32_t kernel;           /* sinew_kernel; another than AUTO is for tests and measurements */
  uint32_t weights_in_place; /* 1: the model's weights are read where they lie instead of being packed.
                              * Saves about the model's size, for small devices; slower where kernels want
                              * them packed. Given to sinew_bind_workspace_size() too */
  /* How the caller lends its threads, or null: everything runs on the calling thread. The progress callback is called
   * there in any case, between two calls of parallel_for. The result does not depend on either. */
  sinew_parallel_for parallel_for;
  void* parallel_user;
  uint32_t thread_count; /* 1..64 pieces that work is cut into, as many as threads are to be busy; 0 = 1. Every piece
                          * has scratch of its own: given to sinew_bind_workspace_size() too */
  /* 16..SINEW_MAX_VERTICES: a mesh with more welded vertices is bound on a surface reduced to at most as many, and its
   * rows are interpolated on it; 0 = 32768. Time and most of the workspace hardly grow from there on. Given to
   * sinew_bind_workspace_size() too. */
  uint32_t surface_vertices;
} sinew_options;

/* Bytes sinew_bind() needs for meshes of at most these counts that have no more than corner_count - 2 face_count
 * triangles once polygons are cut. A pure function of its arguments: the same on every host.
 *   model  may be null for SINEW_METHOD_HEAT; less is needed with a packed one
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT; *size_bytes is 0 on failure. */
sinew_status sinew_bind_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                       uint32_t corner_count, uint32_t joint_count, const sinew_options* options,
                                       size_t* size_bytes);

/* Predicts skin weights.
 *   workspace  scratch, 64-byte aligned, size from sinew_bind_workspace_size(); content is undefined afterwards
 *   joints     out [vertex_count x N] uint16 joint indices, N = influence_count, sorted by falling weight, ties by
 *              lower joint index; unused slots are joint 0 with weight 0; no joint twice in a row
 *   weights    out [vertex_count x N] in weight_format; no row is empty
 *   used_bytes out, may be null: high-water mark of the workspace
 * For locked and hinted vertices both outputs are input and stay as they are: joint indices must exist, and a hint's
 * weights must be finite, not negative and not all 0 (SINEW_ERROR_RANGE).
 * Returns SINEW_OK or a status; outputs are untouched on failure. Same bytes on every platform. */
sinew_status sinew_bind(const sinew_model* model, const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                        const sinew_options* options, void* workspace, size_t workspace_bytes, uint16_t* joints,
                        void* weights, size_t* used_bytes);

#ifdef __cplusplus
}
#endif
#endif
