/* SPDX-License-Identifier: MIT
 * Binding: predicts skin weights of a mesh for a skeleton. */
#ifndef SINEW_BIND_H
#define SINEW_BIND_H

#include "sinew/model.h"
#include "sinew/questions.h"
#include "sinew/skeleton.h"
#include "sinew/skin.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_method {
  SINEW_METHOD_MODEL = 0, /* the network of the model */
  SINEW_METHOD_HEAT = 1   /* heat fields alone; model may be null */
} sinew_method;           /* 2: sinew/published.h */

/* Decides which parts (connected pieces of the mesh) are rigid. Artists bind the same geometry rigidly or softly. */
typedef enum sinew_rigid_parts {
  SINEW_RIGID_PARTS_AUTO = 0,   /* the model or the heat field decides */
  SINEW_RIGID_PARTS_ALWAYS = 1, /* every part gets one joint: the one with most of its weight */
  SINEW_RIGID_PARTS_NEVER = 2   /* parts that the model alone makes rigid (19/20 of the weight on one joint, but
                                 * not in the heat field) get the heat field's weights */
} sinew_rigid_parts;

/* Options of a bind: inputs only. Start from SINEW_INIT(sinew_bind_options), which sets every default. The workspace
 * size depends on the options: pass the same ones to sinew_bind_workspace_size() and to sinew_bind(). Later versions
 * add members at the end, whose value 0 keeps this version's behavior; see struct_size in sinew/types.h. */
typedef struct sinew_bind_options {
  uint32_t struct_size;      /* sizeof(sinew_bind_options) */
  uint32_t method;           /* sinew_method */
  uint32_t influence_count;  /* 1..12 influences per vertex; 0 = 4 */
  uint32_t weight_format;    /* sinew_weight_format */
  uint32_t candidate_count;  /* 1..16 joints that each vertex is scored against; 0 = the model's own count. Heat
                              * scores all joints. A model whose layers are tied to its count rejects another one
                              * (SINEW_ERROR_ARGUMENT) */
  uint32_t grid_size;        /* 16..128 voxel cells along the longest side; 0 = the model's own. Heat needs no grid */
  uint32_t surface_vertices; /* 16..SINEW_MAX_VERTICES: a mesh with more welded vertices is bound on a surface reduced
                              * to at most this many, and its rows are interpolated from it; 0 = 32768. Beyond that
                              * count, time and most of the workspace hardly grow */
  uint32_t symmetric;        /* 1: mirrored vertices get mirrored rows, equal to the last bit (on the mirror plane up
                              * to one step, where a sum is odd). The plane x = c is found. Without one the option has
                              * no effect, see sinew_bind_outputs::symmetric_vertices */
  uint32_t rigid_parts;      /* sinew_rigid_parts; locked vertices and hints take precedence */
  uint32_t softness_percent; /* 25..400: softness of the model's weights in percent, 200 = twice as soft; 0 = 100. Not
                              * for SINEW_METHOD_HEAT */
  uint32_t weights_in_place; /* 1: reads the model's weights in place instead of packing them. Saves memory of about
                              * the model's size, for small devices; slower for kernels that use packed weights */
  uint32_t kernel;           /* sinew_kernel; other values than AUTO are for tests and measurements */
  uint32_t thread_count;     /* 1..64 pieces of work to run in parallel; 0 = 1. Each has its own scratch memory */
  uint32_t reserved;         /* 0 */
  const uint8_t* locked;     /* [vertex_count] non-zero: the vertex keeps its row in the outputs; or null */
  const uint8_t* hints;      /* [vertex_count] non-zero: a hint. The vertex keeps its row in the outputs, as if it
                              * were locked, and guides its surroundings: the difference between the given and the
                              * predicted row is spread over the connected part of the mesh, weaker with distance; or
                              * null */
  sinew_parallel_for parallel_for; /* runs work on the caller's threads; null: the calling thread alone. The result is
                                    * the same */
  void* parallel_user;
  sinew_progress progress; /* called on the calling thread, between calls of parallel_for; or null */
  void* progress_user;
  const sinew_answer* answers; /* [answer_count] the user's answers about parts; or null */
  uint32_t answer_count;       /* 0 .. SINEW_MAX_QUESTIONS */
  uint32_t question_count;     /* 0 .. SINEW_MAX_QUESTIONS: maximum number of parts to list as questions, see
                                * sinew_bind_outputs::questions. Parts with an answer are not listed */
} sinew_bind_options;

/* Outputs of a bind: the caller's arrays, and numbers that the call writes. Start from
 * SINEW_INIT(sinew_bind_outputs). N is sinew_bind_options::influence_count, 4 by default. Later versions add members
 * at the end, as in sinew_bind_options. */
typedef struct sinew_bind_outputs {
  uint32_t struct_size;        /* sizeof(sinew_bind_outputs) */
  uint32_t symmetric_vertices; /* written: with sinew_bind_options::symmetric, number of vertices with a mirror image
                                * (themselves, on the plane); 0: no mirror plane was found and symmetric had no effect */
  uint16_t* joint_indices;     /* [vertex_count x N] sorted by descending weight, ties by lower joint index; unused
                                * slots are joint 0 with weight 0; joints are unique in a row */
  void* weights;               /* [vertex_count x N] in weight_format; no row is empty */
  uint8_t* confidence;         /* [vertex_count] probability that the strongest joint is the one an artist would
                                * choose, 0..255 = 0..100 %: its predicted share, calibrated by the model's confidence
                                * table if it has one (sinew_model::confidence_count). 255 for locked and hinted
                                * vertices. Null = not wanted */
  size_t used_bytes;           /* written: high-water mark of the workspace */
  sinew_question* questions;   /* [sinew_bind_options::question_count] questions by descending gain; null if
                                * question_count is 0 */
  uint32_t* vertex_questions;  /* [vertex_count] index of the question about the vertex's part, or SINEW_NO_QUESTION;
                                * null = not wanted */
  uint32_t* vertex_parts; /* [vertex_count] part of the vertex: 0 has the most vertices, and so on; null = not wanted.
                           * All three only with question_count or answers */
  uint32_t questions_written; /* written: number of questions */
  uint32_t reserved;          /* 0 */
} sinew_bind_outputs;

/* Returns the bytes that sinew_bind() needs for meshes of at most these counts, with at most corner_count - 2
 * face_count triangles after triangulation. A pure function of its arguments: the same on every host.
 *   model       null for SINEW_METHOD_HEAT; a packed model needs fewer bytes
 *   options     null = all defaults; only whether its pointers are null matters
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, or like sinew_bind() SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION or SINEW_ERROR_COUNT, the last
 * also if the size does not fit into size_t. */
SINEW_API sinew_status sinew_bind_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                                 uint32_t corner_count, uint32_t joint_count,
                                                 const sinew_bind_options* options, size_t* size_bytes);

/* Predicts skin weights. The same bytes on every platform, for any kernel and any number of threads.
 *   model      null for SINEW_METHOD_HEAT
 *   options    null = all defaults
 *   workspace  scratch, 64-byte aligned, size from sinew_bind_workspace_size(); its content is undefined afterwards
 *   outputs    joint_indices and weights must be set. Rows of locked and hinted vertices are inputs and stay as they
 *              are: their joint indices must exist, and a hint's weights must be finite, not negative and not all 0
 *
 * Overlap: inputs are only read and may overlap one another. The workspace, the structs and the output arrays must
 * not overlap each other or any input, including the model's bytes and its packed memory.
 * Threads: any number of calls may run at once. They may share a model, its packed memory, meshes, skeletons and
 * options, which are only read; each call needs its own workspace and outputs.
 *
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, the model is not open, struct_size is smaller than in
 *                           the first release (such as 0) or above 4096, an option or an answer's kind is out of
 *                           range, or sinew_skeleton::up is X
 *   SINEW_ERROR_NOT_BUILT   the library was built without a requested feature
 *   SINEW_ERROR_VERSION     a member unknown to this library is not 0
 *   SINEW_ERROR_MODEL_TASK  the model is made for another task: sinew_model::task is not 0
 *   SINEW_ERROR_COUNT       no vertex or joint, a count above the limits in sinew/types.h, or fewer than two corners
 *                           per face
 *   SINEW_ERROR_KERNEL      this library or this processor lacks sinew_bind_options::kernel
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_RANGE       a locked or hinted row names a joint that does not exist, or a hint's weights are
 *                           invalid; an answer names a vertex or a joint that does not exist, or a joint that must
 *                           not get weight
 *   SINEW_ERROR_NOT_FINITE  a position of a vertex or joint is NaN or infinite
 *   SINEW_ERROR_INDEX       face_offsets do not start at 0, are not ascending, or do not end at corner_count;
 *                           corner_count is not 3 face_count without them; a face has fewer than two corners or names
 *                           a vertex that does not exist; a parent does not exist
 *   SINEW_ERROR_HIERARCHY   joint parents form a cycle
 *   SINEW_ERROR_NO_JOINT    no joint may get weight
 *   SINEW_ERROR_CANCELLED   the progress callback asked to stop */
SINEW_API sinew_status sinew_bind(const sinew_model* model, const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                                  const sinew_bind_options* options, void* workspace, size_t workspace_bytes,
                                  sinew_bind_outputs* outputs);

#ifdef __cplusplus
}
#endif
#endif
