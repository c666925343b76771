/* SPDX-License-Identifier: MIT
 * Rigging: predicts a skeleton for a bare mesh. What it gives, sinew_bind() takes as it is. */
#ifndef SINEW_RIG_H
#define SINEW_RIG_H

#include "sinew/model.h"
#include "sinew/skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_MAX_RIG_JOINTS 192u
#define SINEW_JOINT_NAME_BYTES 32u

/* What a joint is for. Front legs of animals are arms, hind legs are legs. Numbers are never reused. */
typedef enum sinew_joint_class {
  SINEW_CLASS_PELVIS = 0,
  SINEW_CLASS_SPINE = 1,
  SINEW_CLASS_NECK = 2,
  SINEW_CLASS_HEAD = 3,
  SINEW_CLASS_CLAVICLE = 4,
  SINEW_CLASS_UPPER_ARM = 5,
  SINEW_CLASS_FOREARM = 6,
  SINEW_CLASS_HAND = 7,
  SINEW_CLASS_HIP = 8,
  SINEW_CLASS_THIGH = 9,
  SINEW_CLASS_CALF = 10,
  SINEW_CLASS_FOOT = 11,
  SINEW_CLASS_TOE = 12,
  SINEW_CLASS_TAIL = 13,
  SINEW_CLASS_WING = 14,
  SINEW_CLASS_EAR = 15,
  SINEW_CLASS_HAIR = 16,
  SINEW_CLASS_OTHER = 17,
  SINEW_CLASS_THUMB = 19, /* fingers, of sinew_rig_details() alone */
  SINEW_CLASS_INDEX = 20,
  SINEW_CLASS_MIDDLE = 21,
  SINEW_CLASS_RING = 22,
  SINEW_CLASS_PINKY = 23,
  SINEW_CLASS_EYE = 24, /* this and the next two: of sinew_rig_details() alone */
  SINEW_CLASS_JAW = 25,
  SINEW_CLASS_PROP = 26
} sinew_joint_class;

/* Whether the skeleton is to be its own mirror image. */
typedef enum sinew_mirror {
  SINEW_MIRROR_AUTO = 0,   /* where the mesh is, within 3 % of its longest side */
  SINEW_MIRROR_ALWAYS = 1, /* about the plane that fits best */
  SINEW_MIRROR_NEVER = 2
} sinew_mirror;

/* Where a mesh's front is, in its own axes. An axis that is up is SINEW_ERROR_ARGUMENT. Numbers are never reused. */
typedef enum sinew_front {
  SINEW_FRONT_AUTO = 0, /* found */
  SINEW_FRONT_PLUS_Z = 1,
  SINEW_FRONT_MINUS_Z = 2,
  SINEW_FRONT_PLUS_X = 3,
  SINEW_FRONT_MINUS_X = 4,
  SINEW_FRONT_PLUS_Y = 5, /* this and the next: with z up */
  SINEW_FRONT_MINUS_Y = 6
} sinew_front;

/* Where the skeleton comes from. */
typedef enum sinew_rig_method {
  SINEW_RIG_VOTES = 0, /* from what the model has learned */
  SINEW_RIG_SHAPE = 1  /* from the middle line of the mesh alone, for what no model knows: the model may be null. Joints
                        * are named Bone, of class OTHER and confidence 0; spread is 0, facing 0 or 1 */
} sinew_rig_method;    /* 2: sinew/published.h */

/* What kind of body the mesh has, by the caller's word. Numbers are never reused.
 * SINEW_RIG_VOTES: it says what limbs are. BIPED: the lowest pair are legs, others arms. QUADRUPED: the rearmost pair are legs,
 * others arms. BIRD: arms are wings. FISH: all limbs are wings, for fins. SNAKE: it has no limbs. MANY_LEGGED: all are legs.
 * SINEW_RIG_SLOTS: it says which slots there are. ANY: all. BIPED: trunk, arms, legs. QUADRUPED: these, tail, ears. BIRD: trunk,
 * legs, wings, tail. FISH: trunk, tail, wings. SNAKE: trunk, tail. MANY_LEGGED: trunk, arms, legs, tail.
 * VEHICLE is no body: sinew_rig() refuses it, sinew_character_rig() finds wheels, a turret and doors by the mesh's parts. */
typedef enum sinew_category {
  SINEW_CATEGORY_ANY = 0,
  SINEW_CATEGORY_BIPED = 1,
  SINEW_CATEGORY_QUADRUPED = 2,
  SINEW_CATEGORY_BIRD = 3,
  SINEW_CATEGORY_FISH = 4,
  SINEW_CATEGORY_SNAKE = 5,
  SINEW_CATEGORY_MANY_LEGGED = 6,
  SINEW_CATEGORY_VEHICLE = 7
} sinew_category;

/* What a call is asked to do: inputs only. Start from SINEW_INIT(sinew_rig_options), which asks for every default.
 * Later versions add members at the end, and 0 asks for what this version does; see struct_size in sinew/types.h. */
typedef struct sinew_rig_options {
  uint32_t struct_size;      /* sizeof(sinew_rig_options) */
  uint32_t up;               /* sinew_up of the mesh */
  uint32_t mirror;           /* sinew_mirror */
  uint32_t spine_count;      /* 1..16 joints between pelvis and neck or head; 0 = as the model says */
  uint32_t without;          /* bits of sinew_without: SINEW_WITHOUT_TOES, SINEW_WITHOUT_ENDS */
  uint32_t reserved;         /* 0 */
  uint32_t weights_in_place; /* as in sinew_bind_options */
  uint32_t kernel;           /* sinew_kernel; another than AUTO is for tests and measurements */
  sinew_progress progress;   /* or null */
  void* progress_user;
  uint32_t method;   /* sinew_rig_method */
  uint32_t category; /* sinew_category of SINEW_RIG_VOTES and of SINEW_RIG_SLOTS in published.h; else 0 */
  /* Of sinew_rig_model_open(), made for fronts: which way the mesh faces is found at any angle, and with SINEW_UP_AUTO which
   * of y and z is up. Null: SINEW_UP_AUTO is y, and the front is one of four, by where the votes are surest */
  const sinew_model* front_model;
  uint32_t front; /* sinew_front */
  uint32_t
      axes_known; /* 1: the mesh's file says that y is up and +z front, which counts where the mesh itself does not tell */
} sinew_rig_options;

/* What a call gives: the caller's arrays, each with room for SINEW_MAX_RIG_JOINTS, and numbers that the call writes. Start
 * from SINEW_INIT(sinew_rig_outputs). Parents come before their children, joint 0 is the root. Later versions add members at the
 * end, as in sinew_rig_options. */
typedef struct sinew_rig_outputs {
  uint32_t struct_size;        /* sizeof(sinew_rig_outputs) */
  uint32_t joint_count;        /* written: J, at least 1 */
  float* positions;            /* [J x 3] in the mesh's units and axes */
  int32_t* parents;            /* [J] -1 for the root */
  uint8_t* flags;              /* [J] for sinew_skeleton: SINEW_JOINT_NEVER for bone ends, else 0; null = not wanted */
  uint8_t* joint_classes;      /* [J] sinew_joint_class; a bone end's is its joint's; null = not wanted */
  int32_t* partners;           /* [J] the joint's mirror image, itself on the plane, -1 where it has none; null
                                   * = not wanted */
  uint16_t* confidence;        /* [J] how sure the joint's position is, 0..32768; null = not wanted */
  uint16_t* parent_confidence; /* [J] how sure its parent is, 0..32768; null = not wanted */
  /* [J] Hips, Spine, LeftArm, ... Head_end; every name once; null = not wanted */
  char (*names)[SINEW_JOINT_NAME_BYTES];
  uint32_t mirrored; /* written: 1 when the skeleton is its own mirror image */
  /* written: the nearest of where it faces: 0 = +z, 1 = +x, 2 = -z, 3 = -x, in axes with y up. Left is to the left of that.
   * Where it faces exactly so the mirror plane is across x for 0 and 2, else across z */
  uint32_t facing;
  /* written: where the plane is on that axis, the mesh's units; where `front` is between the axes, on the horizontal axis
   * across it that has positive x */
  float plane;
  /* written: how far off the votes think they are, in the mean, share of the longest side. Below about 0.03 the whole
   * skeleton is good, above 0.09 the votes are no better than SINEW_RIG_SHAPE. At least 0.1 for a sheet: nearly all of its
   * surface faces one direction or the opposite one */
  float spread;
  size_t used_bytes; /* written: high-water mark of the workspace */
  float front[3];    /* written: unit vector, the mesh's axes */
  uint32_t up;       /* written: sinew_up of the mesh, Y or Z */
  /* written: how likely `front` is right within 60 degrees, and `up`, 0..1: with sinew_rig_options::front_model, fitted on
   * makers that it had not seen, and lower of a mesh without a mirror plane; below 0.7 it is a coin toss. 1 where it was given; front_confidence is 0 without the model */
  float front_confidence, up_confidence;
} sinew_rig_outputs;

/* Checks a model for sinew_rig(), made for bodies or for fronts, or, made for hands, for sinew_rig_details(), as sinew_model_open() checks one for
 * sinew_bind(), with the same results. */
SINEW_API sinew_status sinew_rig_model_open(const void* bytes, size_t size_bytes, sinew_model* model);

/* Bytes sinew_rig() needs for meshes of at most these counts. A pure function of its arguments: the same on every host.
 *   options     null = all defaults
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, or as sinew_rig() does SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION, SINEW_ERROR_MODEL_TASK or
 * SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_rig_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                                uint32_t corner_count, const sinew_rig_options* options,
                                                size_t* size_bytes);

/* Predicts a skeleton. The same bytes on every platform and for any kernel, however the mesh is numbered.
 *   mesh       any topology; without faces its vertices are all that is seen
 *   options    null = all defaults
 *   workspace  scratch, 64-byte aligned, size from sinew_rig_workspace_size(); its content is undefined afterwards
 *   outputs    positions and parents must be set
 *
 * Overlap and threads: as for sinew_bind().
 *
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, the model is not open, struct_size is too small or above
 *                           4096, or an option is out of its range
 *   SINEW_ERROR_NOT_BUILT   the library was built without what is asked for
 *   SINEW_ERROR_VERSION     a member behind those that this library knows is not 0
 *   SINEW_ERROR_MODEL_TASK  the model is made for another task: sinew_model::task is not 1, or feature_set is 2 (hands); or
 *                           front_model is not made for fronts: feature_set 5
 *   SINEW_ERROR_COUNT       no vertex, more of anything than the limits in sinew/types.h, or fewer than two corners a face
 *   SINEW_ERROR_KERNEL      this library or this processor lacks sinew_rig_options::kernel
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position is NaN or infinite
 *   SINEW_ERROR_INDEX       faces break the rules of sinew_mesh
 *   SINEW_ERROR_CANCELLED   the progress callback asked to stop */
SINEW_API sinew_status sinew_rig(const sinew_model* model, const sinew_mesh* mesh, const sinew_rig_options* options,
                                 void* workspace, size_t workspace_bytes, sinew_rig_outputs* outputs);

/* What sinew_rig_details() can add to a skeleton, bits of `wanted`. Numbers are never reused. */
typedef enum sinew_rig_detail {
  SINEW_DETAIL_HANDS = 1, /* fingers */
  SINEW_DETAIL_FACE = 2,  /* eyes and jaws; needs no model */
  SINEW_DETAIL_PROPS = 4  /* what hands hold; needs no model */
} sinew_rig_detail;

/* Bytes sinew_rig_details() needs for meshes of at most these counts, whatever the skeleton. As sinew_rig_workspace_size(). */
SINEW_API sinew_status sinew_rig_details_workspace_size(const sinew_model* hands_model, uint32_t vertex_count,
                                                        uint32_t face_count, uint32_t corner_count, uint32_t wanted,
                                                        const sinew_rig_options* options, size_t* size_bytes);

/* Lets a skeleton grow by what the mesh shows. The same bytes on every platform and for any kernel. In this order:
 *   HANDS  Each hand is cut out of the mesh and looked at by itself. A hand is a leaf of class SINEW_CLASS_HAND with a parent,
 *          bone ends aside. It gets as many fingers as the mesh shows, none where the votes do not agree: mittens, fists,
 *          paws. A finger has two or three joints and a bone end, of the classes SINEW_CLASS_THUMB to SINEW_CLASS_PINKY; its
 *          names begin with the hand's, of which the first 20 letters: LeftHandThumb1, LeftHandThumb3_end. A bone end of the
 *          hand goes. Of two hands that are each other's mirror image the left one is looked at, and the right one is its
 *          image
 *   FACE   Heads, joints of SINEW_CLASS_HEAD, get children LeftEye and RightEye (SINEW_CLASS_EYE) in the middles of two loose
 *          parts of the mesh that are balls and lie like eyes. Upright heads get Jaw, where it rotates, and the bone end
 *          Jaw_end at the chin (SINEW_CLASS_JAW), which follow from the eyes. Heads whose eyes are painted or part of the
 *          skin, or that have an eye or a jaw, stay as they are
 *   PROPS  A hand that holds a loose part of the mesh gets a joint of SINEW_CLASS_PROP for it, so that it is bound as a rigid
 *          child. Such a part begins at the hand, reaches far beyond it and stays clear of the arm. RightHandProp is where
 *          the part is nearest to the hand, the bone end RightHandProp_end where it is farthest. A hand with a prop stays as
 *          it is
 * Names are numbered where they are taken. Hands and heads whose joints have no room stay as they are.
 *   hands_model  of sinew_rig_model_open(), made for hands; null is fine without SINEW_DETAIL_HANDS
 *   wanted       sinew_rig_detail bits, at least one
 *   options      those of sinew_rig(): up, weights_in_place, kernel and progress are looked at; null = all defaults
 *   outputs      in: joint_count, positions, parents and joint_classes as sinew_rig() gave them or the caller changed them;
 *                mirrored, facing, plane, front and up as they were (front all 0: by `facing`); partners, flags and names too where they are set. Each array has
 *                room for SINEW_MAX_RIG_JOINTS.
 *                out: the same with new joints behind the others, or in place of a hand's bone end; used_bytes
 *
 * Overlap and threads: as for sinew_bind().
 *
 * Returns SINEW_OK, or with outputs untouched what sinew_rig() does, and
 *   SINEW_ERROR_ARGUMENT    joint_classes is null, or `wanted` is 0 or has other bits
 *   SINEW_ERROR_MODEL_TASK  the model is not made for hands: sinew_model::task is not 1 or feature_set is not 2
 *   SINEW_ERROR_COUNT       joint_count is 0 or above SINEW_MAX_RIG_JOINTS
 *   SINEW_ERROR_INDEX       a parent does not come before its child, or a partner is no joint
 *   SINEW_ERROR_NOT_FINITE  a joint's position is NaN or infinite
 * Bodies and hands tell their models apart: sinew_rig() refuses one for hands with SINEW_ERROR_MODEL_TASK. */
SINEW_API sinew_status sinew_rig_details(const sinew_model* hands_model, const sinew_mesh* mesh, uint32_t wanted,
                                         const sinew_rig_options* options, void* workspace, size_t workspace_bytes,
                                         sinew_rig_outputs* outputs);

#ifdef __cplusplus
}
#endif
#endif
