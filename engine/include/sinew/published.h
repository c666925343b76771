/* SPDX-License-Identifier: MIT
 * Methods as others published them, for comparison. sinew/sinew.h does not include this header, and a library built with
 * -DSINEW_PUBLISHED_METHODS=OFF holds none of them: calls that ask for one return SINEW_ERROR_NOT_BUILT. */
#ifndef SINEW_PUBLISHED_H
#define SINEW_PUBLISHED_H

#include "sinew/bind.h"
#include "sinew/deform.h"
#include "sinew/map.h"
#include "sinew/motion_clips.h"
#include "sinew/rig.h"
#include "sinew/transfer.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Vertices of the larger mesh that SINEW_TRANSFER_BIHARMONIC takes. It uses at most 1,200 reference points,
 * as drawn and of a caller SINEW_MAX_TRANSFER_PAIRS. */
#define SINEW_MAX_BIHARMONIC_VERTICES 65536u

/* Values of the `method` of options beside those of the call's own enum, which skips them. Numbers are never reused. */
enum {
  /* sinew_bind_options: by distance to bones; model may be null. Vertices nearest to a bone are a sub-mesh, on which that bone
   * and those beside it in the hierarchy have weights by the inverse square of their distance */
  SINEW_METHOD_DISTANCE = 2,
  /* sinew_rig_options: as SINEW_RIG_SHAPE, but from regions of the surface, their boxes and contacts, as published for
   * mapping skeletons. Nothing is mirrored */
  SINEW_RIG_REGIONS = 2,
  /* sinew_rig_options: joints in 44 fixed slots and a matrix of connections, by two networks; the model has both. Nothing is
   * mirrored. Slots that the body's `category` has not stay empty. spread is a quarter of how far apart the surface's points
   * put a joint, at least 0.1 for a sheet: above 0.05 the mesh resembles little that the networks know */
  SINEW_RIG_SLOTS = 3,
  /* sinew_map_options: paths from the root to every leaf, matched by the costs of their joints (position, position in the branch,
   * branches through it, bones, surface); several joints may get one source. Mirrored branches only get mirrored ones; what
   * can only cross another's way gets the other root; every source joint that moves and has more than three bones is given to
   * a joint. SINEW_MAP_AUTO takes it too where it is built and fits better */
  SINEW_MAP_BRANCHES = 2,
  /* sinew_deform_options: linear blending, then stretch, energy (k = 0.2) and volume of the lattice's tetrahedra with
   * contact by extended position-based dynamics, and smoothing of the bends in proportion to their angle */
  SINEW_DEFORM_XPBD = 1,
  /* sinew_transfer_options: vertices that have like biharmonic distances to reference points; needs no alike shape, and
   * less fits. */
  SINEW_TRANSFER_BIHARMONIC = 2
};

/* sinew_map_options.branches_first: whose branches choose one of the other skeleton's each. Numbers are never reused. */
typedef enum sinew_branches_first {
  SINEW_BRANCHES_BOTH = 0, /* both ways are tried: the cheaper one */
  SINEW_BRANCHES_TARGET = 1,
  SINEW_BRANCHES_SOURCE = 2
} sinew_branches_first;

/* sinew_map_options.branches_cost: of two branches. Numbers are never reused. */
typedef enum sinew_branches_cost {
  SINEW_BRANCHES_MEAN = 0, /* of their pairs of joints */
  SINEW_BRANCHES_SUM = 1   /* favors short branches */
} sinew_branches_cost;

#define SINEW_NO_AREA 0xFFFFFFFFu /* sinew_reference_options.area_power: 0, which as a number asks for the default */
#define SINEW_NO_FALLOFF (-1.0f)  /* sinew_reference_options.falloff: none, as drawn; 0 asks for the default */

/* Start from SINEW_INIT(sinew_reference_options). Later versions add members at the end, as in sinew_retarget_options. Legs are
 * left as they are copied unless asked for, because feet leave the floor by it. */
typedef struct sinew_reference_options {
  uint32_t struct_size; /* sizeof(sinew_reference_options) */
  uint32_t area_power;  /* n, 1 .. 4, or SINEW_NO_AREA for 0; 0 = 3 */
  uint32_t own_limb;    /* 1: triangles of the limb itself have influence as well */
  uint32_t legs;        /* 1: knees and ankles move as well */
  float falloff; /* d: influence also falls by exp(-(distance / (d * source's height))^2); 0 = 0.05, which is ours */
  float least_cosine;      /* eps, up to 1; 0 = 1e-5 */
  sinew_progress progress; /* or null */
  void* progress_user;
  uint32_t head;  /* 1: the head moves as well */
  uint32_t torso; /* 1: torso joints lie as the source's do, each seen from the one before; 0: they turn as copied */
  uint32_t source_points; /* 1: reference points are the source's, in the size of the target; 0: the target's */
  uint32_t
      as_drawn; /* 1: as published: one sum over all triangles, the limb's own too; knees, ankles, head and torso as well; the
                           * source's reference points; no falloff, no push-out. own_limb to source_points say nothing then */
} sinew_reference_options;

/* Bytes sinew_retarget_reference_points() needs.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, or SINEW_ERROR_COUNT where that is more than memory can hold. */
SINEW_API sinew_status sinew_retarget_reference_points_workspace_size(const sinew_retarget* plan,
                                                                      const sinew_motion_body* target,
                                                                      size_t* size_bytes);

/* Retargeting by reference points on the mesh; sinew_retarget_contacts() is better. Changes arms of frames that
 * sinew_retarget_frame() made, and what else the options name. Frames do not know of each other, so that a clip may be one live frame.
 *   Reference points are the middles c of the triangles. For elbows and wrists of the source v = joint - c. A triangle's
 * influence is (area / mean area)^n max(|cos(v, normal)|, eps). Torso, head and every limb wish apart: the sum of
 * influence (c' + v t' / t) over the sum of influence; the joint's position is the mean of their wishes, which count (ours) by the
 * fourth power of their nearness. Here t and t' are lengths of the source's and the target's bones
 * as seen along v, summed over the path through the skeleton from the joint nearest to c at rest. Where t is 0, t' / t is the
 * ratio of heights. Arms bend so that elbow and wrist come there, with bones of their length; a hand or
 * forearm that lies deeper in the body than the source's, and than it was copied, comes out (ours); all else stays as it was
 * copied.
 *   source  the body that moved, of the same vertices and triangles as the target's (its `triangles` are not looked at), as
 *           sinew_corresponding_points() makes one of any mesh; null: capsules round both skeletons stand for the bodies,
 *           the source's as thick as limbs of such proportions are, the target's as its mesh is there; they push elbows and wrists
 *           straight out and do no more (ours)
 *   clip    `ground` is not looked at
 * Returns what sinew_retarget_contacts() does; SINEW_ERROR_ARGUMENT also for options out of their
 * range, and SINEW_ERROR_NOT_BUILT. */
SINEW_API sinew_status sinew_retarget_reference_points(sinew_retarget* plan, const sinew_motion_body* source,
                                                       const sinew_motion_body* target, const sinew_motion_clip* clip,
                                                       const sinew_reference_options* options, void* workspace,
                                                       size_t workspace_bytes);

/* Bytes sinew_corresponding_points() needs, as sinew_transfer_workspace_size(). */
SINEW_API sinew_status sinew_corresponding_points_workspace_size(const sinew_bound_character* source,
                                                                 const sinew_mesh* target,
                                                                 const sinew_skeleton* skeleton, size_t* size_bytes);

/* Which point of a character's surface every vertex of another mesh is: what SINEW_TRANSFER_NEAREST carries weights by. With
 * it the source has a body of the target's vertices and triangles for sinew_retarget_reference_points(): the points, with the
 * weights of the three vertices by their shares.
 *   source, target, skeleton, workspace  as in sinew_transfer()
 *   vertices  out, [vertex_count of target x 3] vertices of the source
 *   shares    out, the same, sums 1
 * Returns what sinew_transfer() does for SINEW_TRANSFER_NEAREST, and SINEW_ERROR_NOT_BUILT; outputs are untouched on failure. */
SINEW_API sinew_status sinew_corresponding_points(const sinew_bound_character* source, const sinew_mesh* target,
                                                  const sinew_skeleton* skeleton, void* workspace,
                                                  size_t workspace_bytes, uint32_t* vertices, float* shares);

#ifdef __cplusplus
}
#endif
#endif
