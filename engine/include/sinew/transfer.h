/* SPDX-License-Identifier: MIT
 * Transfer: copies the weights of a bound character to another mesh, with the same or another skeleton. */
#ifndef SINEW_TRANSFER_H
#define SINEW_TRANSFER_H

#include "sinew/bind.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Maximum number of pairs of vertices from the caller. */
#define SINEW_MAX_TRANSFER_PAIRS 128u

typedef enum sinew_transfer_method {
  /* A blend of NEAREST and REBIND per vertex: the more the source's weights differ from a bind of the source, and the
   * better the two meshes match, the more weight is transferred */
  SINEW_TRANSFER_AUTO = 0,
  /* Weights of the nearest point on the source's surface, after its bones are aligned with the target's; interpolated
   * smoothly where no point is near */
  SINEW_TRANSFER_NEAREST = 1,
  /* sinew_bind() of the target, by model or heat, whichever is closer to the source's weights on the source */
  SINEW_TRANSFER_REBIND = 3
} sinew_transfer_method; /* 2: sinew/published.h */

/* The bound character that weights come from, borrowed for the duration of a call. This struct never changes. */
typedef struct sinew_bound_character {
  const sinew_mesh* mesh;
  const sinew_skeleton* skeleton;
  sinew_skin skin; /* of the mesh for the skeleton, in any weight_format */
  /* [joint_count of skeleton] matching joint of the target, or -1. The weight of a joint without one goes to the
   * nearest ancestor that has one, else to the nearest descendant. Several joints may share one */
  const int32_t* joint_map;
} sinew_bound_character;

/* A vertex of the source and the vertex of the target at the same point of the body. */
typedef struct sinew_vertex_pair {
  uint32_t source, target;
} sinew_vertex_pair;

/* Options of a transfer: inputs only. Start from SINEW_INIT(sinew_transfer_options), which sets every default. Later
 * versions add members at the end, whose value 0 keeps this version's behavior; see struct_size in sinew/types.h. */
typedef struct sinew_transfer_options {
  uint32_t struct_size;      /* sizeof(sinew_transfer_options) */
  uint32_t method;           /* sinew_transfer_method */
  uint32_t influence_count;  /* 1..12 influences per vertex; 0 = 4 */
  uint32_t weight_format;    /* sinew_weight_format of the outputs */
  uint32_t garment;          /* 1: the source wears the target: both have the same space, skeleton and up axis. Near
                             * the body its weights are transferred, far from it the dressed character is bound. Not
                             * for SINEW_TRANSFER_BIHARMONIC */
  uint32_t as_drawn;         /* 1: SINEW_TRANSFER_BIHARMONIC as published: unscaled distances to all reference points
                             * have equal weight. Suitable only for bodies with the same proportions */
  uint32_t weights_in_place; /* as in sinew_bind_options */
  uint32_t kernel;           /* sinew_kernel; other values than AUTO are for tests and measurements */
  uint32_t thread_count;     /* 1..64 pieces of work to run in parallel; 0 = 1 */
  uint32_t pair_count;       /* 0 .. SINEW_MAX_TRANSFER_PAIRS */
  const uint8_t* locked;     /* [vertex_count of the target] non-zero: the vertex keeps its row in the outputs; or
                              * null */
  /* [pair_count] reference points of SINEW_TRANSFER_BIHARMONIC; none: found on both surfaces */
  const sinew_vertex_pair* pairs;
  sinew_parallel_for parallel_for; /* as in sinew_bind_options; the result does not depend on it */
  void* parallel_user;
  sinew_progress progress; /* or null */
  void* progress_user;
} sinew_transfer_options;

/* How a part of the target got its weights, and why. Numbers are never reused. */
typedef enum sinew_transfer_reason {
  SINEW_TRANSFER_ASKED = 0,    /* as the method requires */
  SINEW_TRANSFER_STYLE = 1,    /* transferred: the source's weights differ from a bind by more than the match error */
  SINEW_TRANSFER_MISMATCH = 2, /* rebound: the match error is larger than that */
  SINEW_TRANSFER_PLAIN = 3,    /* rebound: the source's weights equal a bind */
  SINEW_TRANSFER_NEAR = 4,     /* garment, transferred: it is on the source */
  SINEW_TRANSFER_FAR = 5,      /* garment, rebound: it is away from the source */
  SINEW_TRANSFER_NO_MATCH = 6, /* rebound: none of the joints that move this part has a match */
  SINEW_TRANSFER_KEPT = 7      /* all of its vertices are locked */
} sinew_transfer_reason;

/* Result for a connected piece of the target. This struct never changes. */
typedef struct sinew_transfer_part {
  uint32_t vertex;       /* its vertex of lowest index */
  uint32_t vertex_count; /* of the target */
  uint32_t reason;       /* sinew_transfer_reason of the larger share */
  uint32_t carried_q16;  /* share of its weights that was transferred, 65536 = all; the rest was rebound */
  /* Difference between the source's weights there and a bind: sum over joints, mean over the vertices, 0..131072. 0
   * if nothing was bound. */
  uint32_t style_q16;
  /* The same between a bind of the target and the transferred bind of the source: the match error. */
  uint32_t mismatch_q16;
  /* Mean distance of its vertices from the aligned source, in longest sides of the target. */
  uint32_t distance_q16;
  uint32_t reserved;
} sinew_transfer_part;

/* Outputs of a transfer: the caller's arrays, and numbers that the call writes. Start from
 * SINEW_INIT(sinew_transfer_outputs). N is sinew_transfer_options::influence_count, 4 by default. Later versions add
 * members at the end. */
typedef struct sinew_transfer_outputs {
  uint32_t struct_size;       /* sizeof(sinew_transfer_outputs) */
  uint32_t part_capacity;     /* in: length of parts */
  uint16_t* joint_indices;    /* [vertex_count x N] as in sinew_bind_outputs */
  void* weights;              /* [vertex_count x N] in weight_format; no row is empty */
  uint8_t* confidence;        /* [vertex_count] 0..255 = 0..100 %: agreement between transferred and bound weights, and
                        * between style and match; 255 for locked vertices. Null = not wanted */
  sinew_transfer_part* parts; /* [part_capacity] by descending size; null = not wanted */
  /* [vertex_count] part of each vertex, an index as if all parts were listed; null = not wanted */
  uint32_t* vertex_parts;
  uint32_t part_count;      /* written: parts of the target, may be more than part_capacity */
  uint32_t bound_by;        /* written: sinew_method of the binds, 2 = nothing was bound */
  uint32_t carried_q16;     /* written: as in sinew_transfer_part, over all vertices that are not locked */
  uint32_t style_q16;       /* written: the same */
  uint32_t mismatch_q16;    /* written: the same */
  uint32_t reference_count; /* written: reference points that SINEW_TRANSFER_BIHARMONIC used */
  size_t used_bytes;        /* written: high-water mark of the workspace */
} sinew_transfer_outputs;

/* Returns the bytes that sinew_transfer() needs for meshes and skeletons of these counts. A pure function of its
 * arguments: the same on every host. Uses only counts, formats and whether pointers of the options are null; arrays
 * of meshes and skeletons may be null.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, or like sinew_transfer() SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION, SINEW_ERROR_MODEL_TASK or
 * SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_transfer_workspace_size(const sinew_model* model, const sinew_bound_character* source,
                                                     const sinew_mesh* target, const sinew_skeleton* skeleton,
                                                     const sinew_transfer_options* options, size_t* size_bytes);

/* Transfers weights. The same bytes on every platform, for any kernel and any number of threads.
 *   model      for binds, as in sinew_bind(); null: bind by heat only
 *   source     character that weights come from. Joints without weight there get none in the target's bind either
 *   target     the mesh that gets weights
 *   skeleton   its skeleton, which the rows refer to. A joint without a match in the source shares the weight of its
 *              nearest ancestor, divided as in a bind of the target
 *   options    null = all defaults
 *   workspace  scratch, 64-byte aligned, size from sinew_transfer_workspace_size(); its content is undefined afterwards
 *   outputs    joint_indices and weights must be set. Rows of locked vertices are unchanged
 *
 * Overlap and threads: as for sinew_bind(); source and target may be the same mesh and skeleton.
 *
 * Returns SINEW_OK, or with outputs untouched the errors of sinew_bind() for either character, and
 *   SINEW_ERROR_ARGUMENT  a pointer that must be set is null, an option or the source's skin is out of range, garment
 *                         with SINEW_TRANSFER_BIHARMONIC or with two up axes
 *   SINEW_ERROR_NOT_BUILT the library was built without a requested feature
 *   SINEW_ERROR_COUNT     for SINEW_TRANSFER_BIHARMONIC a mesh of more than SINEW_MAX_BIHARMONIC_VERTICES; for a
 *                         garment both meshes together above the limits in sinew/types.h
 *   SINEW_ERROR_RANGE     joint_map names a joint that the target lacks, a row of the source a joint that the source lacks, a
 *                         pair a vertex that does not exist; no vertex of the source has weight; or fewer than four reference
 *                         points were found for SINEW_TRANSFER_BIHARMONIC: give pairs */
SINEW_API sinew_status sinew_transfer(const sinew_model* model, const sinew_bound_character* source,
                                      const sinew_mesh* target, const sinew_skeleton* skeleton,
                                      const sinew_transfer_options* options, void* workspace, size_t workspace_bytes,
                                      sinew_transfer_outputs* outputs);

#ifdef __cplusplus
}
#endif
#endif
