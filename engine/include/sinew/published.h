/* SPDX-License-Identifier: MIT
 * Methods as others published them, for comparison. sinew/sinew.h does not include this header, and a library built with
 * -DSINEW_PUBLISHED_METHODS=OFF has none of them: calls that select one return SINEW_ERROR_NOT_BUILT. */
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

/* Maximum number of vertices of either mesh for SINEW_TRANSFER_BIHARMONIC. It uses at most 1,200 reference points, or
 * SINEW_MAX_TRANSFER_PAIRS if they come from the caller or with as_drawn. */
#define SINEW_MAX_BIHARMONIC_VERTICES 65536u

/* Values of `method` in options, in addition to those of the call's enum, which skips them. Numbers are never reused. */
enum {
  /* sinew_bind_options: by distance to bones; model may be null. The vertices nearest to a bone form a sub-mesh, on
   * which that bone and its neighbors in the hierarchy have weights by the inverse square of their distance */
  SINEW_METHOD_DISTANCE = 2,
  /* sinew_rig_options: like SINEW_RIG_SHAPE, but from boxes around regions of the surface and their contacts, as
   * published for mapping skeletons. Nothing is mirrored */
  SINEW_RIG_REGIONS = 2,
  /* sinew_rig_options: joints in 44 fixed slots and a matrix of connections, by two networks; the model has both. Nothing is
   * mirrored. Slots outside the body's `category` stay empty. spread is a quarter of the spread of the surface
   * points' predictions of a joint, at least 0.1 for a sheet: above 0.05 the mesh is unlike the training data */
  SINEW_RIG_SLOTS = 3,
  /* sinew_map_options: paths from the root to every leaf, matched by the costs of their joints (position, position in the branch,
   * branches through it, bones, surface); several joints may get one source. Mirrored branches only get mirrored
   * ones; a branch that would cross all others gets the other root; each source joint that moves and has more than
   * three bones is assigned to a joint. SINEW_MAP_AUTO uses it too if it is built and fits better */
  SINEW_MAP_BRANCHES = 2,
  /* sinew_deform_options: linear blending, then stretch, energy (k = 0.2) and volume of the lattice's tetrahedra with
   * contact by extended position-based dynamics, and smoothing of the bends in proportion to their angle */
  SINEW_DEFORM_XPBD = 1,
  /* sinew_transfer_options: by similar biharmonic distances to reference points; the meshes may differ in shape, but
   * the match is less accurate. */
  SINEW_TRANSFER_BIHARMONIC = 2
};

/* sinew_map_options.branches_first: skeleton whose branches each choose a branch of the other skeleton. Numbers are
 * never reused. */
typedef enum sinew_branches_first {
  SINEW_BRANCHES_BOTH = 0, /* the cheaper of the two directions */
  SINEW_BRANCHES_TARGET = 1,
  SINEW_BRANCHES_SOURCE = 2
} sinew_branches_first;

/* sinew_map_options.branches_cost: cost of two branches. Numbers are never reused. */
typedef enum sinew_branches_cost {
  SINEW_BRANCHES_MEAN = 0, /* mean over their pairs of joints */
  SINEW_BRANCHES_SUM = 1   /* sum, which favors short branches */
} sinew_branches_cost;

/* sinew_reference_options.area_power: exponent 0, as the value 0 selects the default. */
#define SINEW_NO_AREA 0xFFFFFFFFu
/* sinew_reference_options.falloff: none, as published; the value 0 selects the default. */
#define SINEW_NO_FALLOFF (-1.0f)

/* Start from SINEW_INIT(sinew_reference_options). Later versions add members at the end, as in
 * sinew_retarget_options. By default legs are only copied, because this method lifts feet off the floor. */
typedef struct sinew_reference_options {
  uint32_t struct_size; /* sizeof(sinew_reference_options) */
  uint32_t area_power;  /* n, 1 .. 4, or SINEW_NO_AREA for 0; 0 = 3 */
  uint32_t own_limb;    /* 1: triangles of the limb itself have influence too */
  uint32_t legs;        /* 1: also corrects knees and ankles */
  float falloff; /* d: influence also falls by exp(-(distance / (d * source's height))^2); 0 = 0.05 (added by sinew) */
  float least_cosine;      /* eps, up to 1; 0 = 1e-5 */
  sinew_progress progress; /* or null */
  void* progress_user;
  uint32_t head;          /* 1: also corrects the head */
  uint32_t torso;         /* 1: copies directions between torso joints; 0: copies their rotations */
  uint32_t source_points; /* 1: reference points of the source's body, scaled to the target; 0: of the target's body */
  /* 1: as published: one sum over all triangles, including the limb's own; knees, ankles, head and torso too; the source's
   * reference points; no falloff, no push-out. own_limb to source_points are ignored */
  uint32_t as_drawn;
} sinew_reference_options;

/* Returns the bytes that sinew_retarget_reference_points() needs.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, or SINEW_ERROR_COUNT if the size does not fit into size_t. */
SINEW_API sinew_status sinew_retarget_reference_points_workspace_size(const sinew_retarget* plan,
                                                                      const sinew_motion_body* target,
                                                                      size_t* size_bytes);

/* Retargeting by reference points on the mesh; sinew_retarget_contacts() is better. Changes the arms in frames from
 * sinew_retarget_frame(), and other parts by options. Frames are independent, so that a clip may be one live frame.
 *   Reference points are the centers c of the triangles. For elbows and wrists of the source v = joint - c. A
 * triangle's influence is (area / mean area)^n max(|cos(v, normal)|, eps). Torso, head and each limb propose a position: the sum
 * of influence (c' + v t' / t) over the sum of influence. The joint's position is the mean of these, weighted (added
 * by sinew) by the fourth power of their nearness. Here t and t' are lengths of the source's and the target's bones
 * as seen along v, summed over the path through the skeleton from the joint nearest to c at rest. Where t is 0, t' /
 * t is the ratio of heights. Arms bend to bring elbow and wrist there and keep their bone lengths; a hand or forearm
 * that is deeper in the body than the source's and than in the copy is moved out (added by sinew). Everything else
 * stays as copied.
 *   source  the source's body, with the same vertices and triangles as the target's (its `triangles` are ignored), as
 *           sinew_corresponding_points() makes one from any mesh; null: capsules around both skeletons replace the
 *           bodies, the source's with the usual thickness of such limbs, the target's with that of its mesh; they
 *           only push elbows and wrists out (added by sinew)
 *   clip    `ground` is ignored
 * Returns what sinew_retarget_contacts() does; SINEW_ERROR_ARGUMENT also for options out of range, and
 * SINEW_ERROR_NOT_BUILT. */
SINEW_API sinew_status sinew_retarget_reference_points(sinew_retarget* plan, const sinew_motion_body* source,
                                                       const sinew_motion_body* target, const sinew_motion_clip* clip,
                                                       const sinew_reference_options* options, void* workspace,
                                                       size_t workspace_bytes);

/* Returns the bytes that sinew_corresponding_points() needs, like sinew_transfer_workspace_size(). */
SINEW_API sinew_status sinew_corresponding_points_workspace_size(const sinew_bound_character* source,
                                                                 const sinew_mesh* target,
                                                                 const sinew_skeleton* skeleton, size_t* size_bytes);

/* Finds the point of a character's surface that matches each vertex of another mesh, as SINEW_TRANSFER_NEAREST does.
 * These points, with the weights of their three vertices blended by shares, form a source body with the target's
 * vertices and triangles for sinew_retarget_reference_points().
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
