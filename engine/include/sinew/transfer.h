/* SPDX-License-Identifier: MIT
 * Transfer: carries the weights of a bound character to another mesh, of the same, a like or another skeleton. */
#ifndef SINEW_TRANSFER_H
#define SINEW_TRANSFER_H

#include "sinew/bind.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Most pairs of vertices that a caller may give. */
#define SINEW_MAX_TRANSFER_PAIRS 128u

typedef enum sinew_transfer_method {
  /* A balance of NEAREST and REBIND, vertex by vertex: the more the source's weights differ from what a bind gives the
   * source, and the better the two meshes match, the more is carried over */
  SINEW_TRANSFER_AUTO = 0,
  /* The nearest point of the source's surface after its bones were laid over the target's, smoothly filled in where
   * nothing is near */
  SINEW_TRANSFER_NEAREST = 1,
  /* sinew_bind() of the target, by model or heat: whichever is nearer to the source's weights on the source */
  SINEW_TRANSFER_REBIND = 3
} sinew_transfer_method; /* 2: sinew/published.h */

/* The bound character that weights come from, borrowed for the time of a call. This struct never changes. */
typedef struct sinew_bound_character {
  const sinew_mesh* mesh;
  const sinew_skeleton* skeleton;
  sinew_skin skin; /* of the mesh for the skeleton, in any weight_format */
  /* [joint_count of skeleton] the target's joint that stands for it, or -1. Its weight then goes to the nearest ancestor
   * that has one, else to the nearest descendant. Several joints may have the same */
  const int32_t* joint_map;
} sinew_bound_character;

/* A vertex of the source and the vertex of the target that is the same point of the body. */
typedef struct sinew_vertex_pair {
  uint32_t source, target;
} sinew_vertex_pair;

/* What a transfer is asked to do: inputs only. Start from SINEW_INIT(sinew_transfer_options), which asks for every default.
 * Later versions add members at the end, and 0 asks for what this version does; see struct_size in sinew/types.h. */
typedef struct sinew_transfer_options {
  uint32_t struct_size;     /* sizeof(sinew_transfer_options) */
  uint32_t method;          /* sinew_transfer_method */
  uint32_t influence_count; /* 1..12 influences a vertex keeps; 0 = 4 */
  uint32_t weight_format;   /* sinew_weight_format of the outputs */
  uint32_t garment;         /* 1: the target is worn by the source: both lie in one space, have one skeleton and one up
                              * axis. Near the body its weights are carried over, far from it the dressed whole is bound.
                              * Not for SINEW_TRANSFER_BIHARMONIC */
  uint32_t as_drawn;        /* 1: SINEW_TRANSFER_BIHARMONIC as published: distances to all reference points, not scaled,
                              * count alike. Fits only where both bodies have the same proportions */
  uint32_t weights_in_place; /* as in sinew_bind_options */
  uint32_t kernel;           /* sinew_kernel; another than AUTO is for tests and measurements */
  uint32_t thread_count;     /* 1..64 pieces that work is cut into; 0 = 1 */
  uint32_t pair_count;       /* 0 .. SINEW_MAX_TRANSFER_PAIRS */
  const uint8_t* locked;     /* [vertex_count of the target] non-zero: keeps the row already in the outputs; or null */
  /* [pair_count] reference points of SINEW_TRANSFER_BIHARMONIC; without any they are found on both surfaces */
  const sinew_vertex_pair* pairs;
  sinew_parallel_for parallel_for; /* as in sinew_bind_options; the result does not depend on it */
  void* parallel_user;
  sinew_progress progress; /* or null */
  void* progress_user;
} sinew_transfer_options;

/* Which path a part of the target took, and why. Numbers are never reused. */
typedef enum sinew_transfer_reason {
  SINEW_TRANSFER_ASKED = 0, /* the method says so */
  SINEW_TRANSFER_STYLE = 1, /* carried over: the source's weights differ from a bind's by more than the match is off */
  SINEW_TRANSFER_MISMATCH = 2, /* bound anew: the match is off by more than that */
  SINEW_TRANSFER_PLAIN = 3,    /* bound anew: the source's weights are what a bind gives */
  SINEW_TRANSFER_NEAR = 4,     /* garment, carried over: it lies on the source */
  SINEW_TRANSFER_FAR = 5,      /* garment, bound anew: it lies away from the source */
  SINEW_TRANSFER_NO_MATCH = 6, /* bound anew: none of the joints that move this part has a counterpart */
  SINEW_TRANSFER_KEPT = 7      /* all of its vertices are locked */
} sinew_transfer_reason;

/* What became of a connected piece of the target. This struct never changes. */
typedef struct sinew_transfer_part {
  uint32_t vertex;       /* its vertex of lowest index */
  uint32_t vertex_count; /* of the target */
  uint32_t reason;       /* sinew_transfer_reason of the larger share */
  uint32_t carried_q16;  /* share of its weights that was carried over, 65536 = all; the rest was bound anew */
  /* How far the source's weights there are from a bind's: sum over joints of the difference, mean over the vertices,
   * 0..131072. 0 where nothing was bound. */
  uint32_t style_q16;
  /* The same between a bind of the target and the source's bind carried over: how far the match is off. */
  uint32_t mismatch_q16;
  /* Mean distance of its vertices from the source as it was laid over the target, longest sides of the target. */
  uint32_t distance_q16;
  uint32_t reserved;
} sinew_transfer_part;

/* What a transfer gives: the caller's arrays, and numbers that the call writes. Start from SINEW_INIT(sinew_transfer_outputs). N is
 * sinew_transfer_options::influence_count, 4 by default. Later versions add members at the end. */
typedef struct sinew_transfer_outputs {
  uint32_t struct_size;    /* sizeof(sinew_transfer_outputs) */
  uint32_t part_capacity;  /* in: length of parts */
  uint16_t* joint_indices; /* [vertex_count x N] as in sinew_bind_outputs */
  void* weights;           /* [vertex_count x N] in weight_format; no row is empty */
  uint8_t* confidence; /* [vertex_count] 0..255 = 0..100 %: what is left of a row where carried and bound weights, or
                                * style and match, contradict each other; 255 for locked vertices. Null = not wanted */
  sinew_transfer_part* parts; /* [part_capacity] by falling size; null = not wanted */
  /* [vertex_count] the part of each vertex, its number as if all were listed; null = not wanted */
  uint32_t* vertex_parts;
  uint32_t part_count;      /* written: parts of the target, may be more than part_capacity */
  uint32_t bound_by;        /* written: sinew_method of the binds, 2 = nothing was bound */
  uint32_t carried_q16;     /* written: as in sinew_transfer_part, over all vertices that are not locked */
  uint32_t style_q16;       /* written: the same */
  uint32_t mismatch_q16;    /* written: the same */
  uint32_t reference_count; /* written: reference points that SINEW_TRANSFER_BIHARMONIC used */
  size_t used_bytes;        /* written: high-water mark of the workspace */
} sinew_transfer_outputs;

/* Bytes that sinew_transfer() needs for meshes and skeletons of these counts. A pure function of its arguments: the same on
 * every host. Counts, formats and whether pointers of the options are null are all that is looked at; meshes' and skeletons'
 * arrays may be null.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, or as sinew_transfer() does SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION, SINEW_ERROR_MODEL_TASK or
 * SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_transfer_workspace_size(const sinew_model* model, const sinew_bound_character* source,
                                                     const sinew_mesh* target, const sinew_skeleton* skeleton,
                                                     const sinew_transfer_options* options, size_t* size_bytes);

/* Carries weights over. The same bytes on every platform, for any kernel and any number of threads.
 *   model      for the binds, as for sinew_bind(); null: they are by heat alone
 *   source     where weights come from. Joints without any weight there get none in the target's bind either
 *   target     the mesh that gets weights
 *   skeleton   its skeleton, which the rows are for. A joint that no joint of the source stands for shares what its nearest
 *              ancestor would get, as a bind of the target divides it
 *   options    null = all defaults
 *   workspace  scratch, 64-byte aligned, size from sinew_transfer_workspace_size(); its content is undefined afterwards
 *   outputs    joint_indices and weights must be set. Rows of locked vertices stay as they are
 *
 * Overlap and threads: as for sinew_bind(); source and target may be the same mesh and skeleton.
 *
 * Returns SINEW_OK, or with outputs untouched what sinew_bind() does for either character, and
 *   SINEW_ERROR_ARGUMENT  a pointer that must be set is null, an option or the source's skin is out of its range, garment with
 *                         SINEW_TRANSFER_BIHARMONIC or with two up axes
 *   SINEW_ERROR_NOT_BUILT the library was built without what is asked for
 *   SINEW_ERROR_COUNT     for SINEW_TRANSFER_BIHARMONIC a mesh of more than SINEW_MAX_BIHARMONIC_VERTICES; for a garment more of
 *                         anything than the limits in sinew/types.h in both meshes together
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
