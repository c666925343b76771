/* SPDX-License-Identifier: MIT
 * Deformation: poses a bound mesh so that bends keep their volume, where sinew/skin.h alone collapses or twists them.
 * A deformer is created once per character and poses it any number of times. */
#ifndef SINEW_DEFORM_H
#define SINEW_DEFORM_H

#include "sinew/skeleton.h"
#include "sinew/skin.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_MAX_DEFORM_CELLS 64u
#define SINEW_MAX_DEFORM_ROUNDS 200u
#define SINEW_MAX_DEFORM_ENERGY 1000000u

/* Correction of a pose. Numbers are never reused. */
typedef enum sinew_deform_method {
  /* Dual quaternions, then a lattice of tetrahedra that keep their volume; contact in bends. The solver uses integers */
  SINEW_DEFORM_VOLUME = 0,
  /* Linear blending, smoothed, with the details of the rest pose restored. For hard weights and small bends: large
   * bends lose volume */
  SINEW_DEFORM_DELTA_MUSH = 2
} sinew_deform_method; /* 1: sinew/published.h */

/* Source of the weights of the tetrahedra, for SINEW_DEFORM_XPBD of sinew/published.h. Numbers are never reused. */
typedef enum sinew_tet_weights {
  SINEW_TET_WEIGHTS_SKIN = 0,    /* the skin around them */
  SINEW_TET_WEIGHTS_DISTANCE = 1 /* distances to bones: the nearest one and those beside it */
} sinew_tet_weights;

/* Options of a deformer: inputs only. Start from SINEW_INIT(sinew_deform_options), which sets every default. Later
 * versions add members at the end, whose value 0 keeps this version's behavior; see struct_size in sinew/types.h.
 *   cell_count       not for delta mush
 *   round_count      more rounds are slower and keep more volume
 *   softness         lower is smoother over time and keeps less volume. Not for delta mush
 *   without          SINEW_WITHOUT_TWIST_SPREAD: a joint's twist about its parent's bone stays at the joint;
 *                    otherwise it is spread along the bone, as by twist joints (SINEW_DEFORM_VOLUME);
 *                    SINEW_WITHOUT_CONTACTS: the two sides of a bend may pass through each other;
 *                    SINEW_WITHOUT_SMOOTHING: no smoothing at the end of SINEW_DEFORM_XPBD
 *   body_contact     1: parts of the body that are not neighbors also keep apart if they overlap by less than two
 *                    cells: an arm and the torso, a thigh and the belly, two thighs, and cloth on them. Takes several
 *                    times as long. If a motion drives limbs through each other, dents may appear for a frame. Not
 *                    for delta mush; runs on the calling thread
 *   as_drawn         a Laplacian smooths the bends without restoring their volume at rest; the tetrahedra have
 *                    weights by distance; contact between all parts of the body is a constraint of the solver, which
 *                    takes several times as long. body_contact and tet_weights are ignored
 *   parallel_for     as in sinew_bind_options, with the same result. If several threads pose one deformer, each calls
 *                    it. For SINEW_DEFORM_VOLUME only
 *   thread_count     more than 1 pays for large lattices: at 64 cells, hardly at 32 */
typedef struct sinew_deform_options {
  uint32_t struct_size;            /* sizeof(sinew_deform_options) */
  uint32_t method;                 /* sinew_deform_method */
  uint32_t cell_count;             /* cells along the longest side, 8..SINEW_MAX_DEFORM_CELLS; 0 = 32 */
  uint32_t round_count;            /* 1..SINEW_MAX_DEFORM_ROUNDS; 0 = 20, SINEW_DEFORM_XPBD 60, delta mush 5 */
  uint32_t softness;               /* compliance of the stretch in 1/256, 1..65535; 0 = 1280 */
  uint32_t without;                /* bits of sinew_without */
  uint32_t thread_count;           /* 1..SINEW_MAX_THREADS pieces of work to run in parallel; 0 = 1 */
  uint32_t body_contact;           /* 1: contact between all parts of the body, not only in bends */
  sinew_parallel_for parallel_for; /* runs work of sinew_deform_pose() on the caller's threads; null: the calling
                                    * thread only */
  void* parallel_user;
  uint32_t energy; /* k of SINEW_DEFORM_XPBD's springs from a tetrahedron's centroid to its corners, in thousandths,
                          * 1..SINEW_MAX_DEFORM_ENERGY; 0 = 200 */
  uint32_t tet_weights; /* sinew_tet_weights, of SINEW_DEFORM_XPBD */
  uint32_t as_drawn;    /* 1: SINEW_DEFORM_XPBD as published */
  uint32_t reserved;    /* 0 */
} sinew_deform_options;

/* A deformer, filled by sinew_deform_create(). The size of the struct never changes. The caller's memory must stay
 * unchanged while the deformer is in use; the mesh, skeleton and weights need not. Any number of threads may pose one
 * deformer, each with its own workspace. */
typedef struct sinew_deformer {
  const void* memory;         /* as given */
  size_t pose_bytes;          /* workspace that sinew_deform_pose() needs */
  uint32_t vertex_count;      /* of the mesh */
  uint32_t joint_count;       /* of the skeleton */
  uint32_t tetrahedron_count; /* 0 for a mesh without faces, which is only skinned */
  uint32_t node_count;        /* corners of the tetrahedra */
  uint32_t split_cell_count;  /* cells that separate several parts of the body */
  uint32_t reserved[7];       /* 0 */
} sinew_deformer;

/* Outputs of a pose: the caller's array, and numbers that the call writes. Start from
 * SINEW_INIT(sinew_deform_outputs). */
typedef struct sinew_deform_outputs {
  uint32_t struct_size;         /* sizeof(sinew_deform_outputs) */
  uint32_t corrected;           /* written: 1; 0 if the matrices have shear or unequal scales, and positions are those
                                 * of sinew_skin_linear() */
  float* positions;             /* [vertex_count x 3] in the mesh's units and axes */
  uint32_t active_tetrahedra;   /* written: number of tetrahedra near bends, which were solved */
  uint32_t inverted_tetrahedra; /* written: number of those that ended inverted */
} sinew_deform_outputs;

/* Returns the bytes that sinew_deform_create() needs for this mesh. Reads the mesh once and uses no memory. The same
 * on every host.
 *   influence_count  of the weights, 1..SINEW_MAX_INFLUENCES
 *   options          null = all defaults
 *   size_bytes       out, 0 on failure
 * Returns what sinew_deform_create() does. */
SINEW_API sinew_status sinew_deform_create_workspace_size(const sinew_mesh* mesh, uint32_t joint_count,
                                                          uint32_t influence_count, const sinew_deform_options* options,
                                                          size_t* size_bytes);

/* Creates a deformer for a bound mesh in the caller's memory.
 *   mesh       any topology: open, many parts, not watertight. Vertices at one position are welded for the lattice
 *   skeleton   joints at rest
 *   skin       of SINEW_WEIGHT_UNORM16; copied
 *   memory     64-byte aligned, size from sinew_deform_create_workspace_size()
 *   deformer   out, untouched on failure
 * Returns SINEW_OK, or
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, or an option,
 *                           the skin's influence_count or weight_format is out of range
 *   SINEW_ERROR_NOT_BUILT   the library was built without a requested feature
 *   SINEW_ERROR_VERSION     a member unknown to this library is not 0
 *   SINEW_ERROR_COUNT       no vertex or joint, a count above the limits in sinew/types.h, or fewer than two corners per
 *                           face
 *   SINEW_ERROR_WORKSPACE   the memory is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position is NaN or infinite
 *   SINEW_ERROR_INDEX       faces break the rules of sinew_mesh, or a parent does not exist
 *   SINEW_ERROR_HIERARCHY   the joint parents form a cycle
 *   SINEW_ERROR_RANGE       a joint index of the weights does not exist */
SINEW_API sinew_status sinew_deform_create(const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                                           const sinew_skin* skin, const sinew_deform_options* options, void* memory,
                                           size_t memory_bytes, sinew_deformer* deformer);

/* Poses a mesh. The result depends on the arguments only, so that frames may be computed in any order. The rest pose
 * is reproduced exactly. The same bytes on every platform.
 *   palette    in  [joint_count x 12] row-major 3x4, pose times inverse bind per joint
 *   workspace  scratch, 64-byte aligned, deformer->pose_bytes; its content is undefined afterwards
 *   outputs    positions must be set
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer is null, or struct_size is out of range
 *   SINEW_ERROR_VERSION     a member unknown to this library is not 0
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  an element of a matrix is NaN or infinite, or above 1e15 */
SINEW_API sinew_status sinew_deform_pose(const sinew_deformer* deformer, const float* palette, void* workspace,
                                         size_t workspace_bytes, sinew_deform_outputs* outputs);

#ifdef __cplusplus
}
#endif
#endif
