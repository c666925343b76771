/* SPDX-License-Identifier: MIT
 * Rigging: predicts a skeleton for a bare mesh. sinew_bind() takes the outputs without changes. */
#ifndef SINEW_RIG_H
#define SINEW_RIG_H

#include "sinew/model.h"
#include "sinew/skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_MAX_RIG_JOINTS 192u
#define SINEW_JOINT_NAME_BYTES 32u

/* Anatomical class of a joint. Front legs of animals are arms, hind legs are legs. Numbers are never reused. */
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
  SINEW_CLASS_THUMB = 19, /* fingers, of sinew_rig_details() only */
  SINEW_CLASS_INDEX = 20,
  SINEW_CLASS_MIDDLE = 21,
  SINEW_CLASS_RING = 22,
  SINEW_CLASS_PINKY = 23,
  SINEW_CLASS_EYE = 24, /* this and the next two: of sinew_rig_details() only */
  SINEW_CLASS_JAW = 25,
  SINEW_CLASS_PROP = 26
} sinew_joint_class;

/* Whether to make the skeleton symmetric. */
typedef enum sinew_mirror {
  SINEW_MIRROR_AUTO = 0,   /* if the mesh is symmetric within 3 % of its longest side */
  SINEW_MIRROR_ALWAYS = 1, /* about the plane that fits best */
  SINEW_MIRROR_NEVER = 2
} sinew_mirror;

/* Direction that a mesh faces, in its own axes. The up axis is SINEW_ERROR_ARGUMENT. Numbers are never reused. */
typedef enum sinew_front {
  SINEW_FRONT_AUTO = 0, /* found */
  SINEW_FRONT_PLUS_Z = 1,
  SINEW_FRONT_MINUS_Z = 2,
  SINEW_FRONT_PLUS_X = 3,
  SINEW_FRONT_MINUS_X = 4,
  SINEW_FRONT_PLUS_Y = 5, /* this and the next: for z up */
  SINEW_FRONT_MINUS_Y = 6
} sinew_front;

/* Source of the skeleton. */
typedef enum sinew_rig_method {
  SINEW_RIG_VOTES = 0, /* predicted by the model */
  SINEW_RIG_SHAPE = 1  /* the medial axis of the mesh, for shapes unlike the training data: the model may be null.
                        * Joints are named Bone, with class OTHER and confidence 0; spread is 0, facing 0 or 1 */
} sinew_rig_method;    /* 2: sinew/published.h */

/* Body class given by the caller. Numbers are never reused.
 * SINEW_RIG_VOTES: classifies limbs. BIPED: the lowest pair are legs, others arms. QUADRUPED: the rearmost pair are legs,
 * others arms. BIRD: arms are wings. FISH: all limbs are wings, for fins. SNAKE: no limbs. MANY_LEGGED: all are legs.
 * SINEW_RIG_SLOTS: selects slots. ANY: all. BIPED: torso, arms, legs. QUADRUPED: these, tail, ears. BIRD: torso, legs,
 * wings, tail. FISH: torso, tail, wings. SNAKE: torso, tail. MANY_LEGGED: torso, arms, legs, tail.
 * VEHICLE is not a body: sinew_rig() rejects it, sinew_character_rig() finds wheels, a turret and doors from the mesh's
 * parts. */
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

/* Options of rigging: inputs only. Start from SINEW_INIT(sinew_rig_options), which sets every default. Later versions
 * add members at the end, whose value 0 keeps this version's behavior; see struct_size in sinew/types.h. */
typedef struct sinew_rig_options {
  uint32_t struct_size;      /* sizeof(sinew_rig_options) */
  uint32_t up;               /* sinew_up of the mesh */
  uint32_t mirror;           /* sinew_mirror */
  uint32_t spine_count;      /* 1..16 joints between pelvis and neck or head; 0 = as predicted */
  uint32_t without;          /* bits of sinew_without: SINEW_WITHOUT_TOES, SINEW_WITHOUT_ENDS */
  uint32_t reserved;         /* 0 */
  uint32_t weights_in_place; /* as in sinew_bind_options */
  uint32_t kernel;           /* sinew_kernel; other values than AUTO are for tests and measurements */
  sinew_progress progress;   /* or null */
  void* progress_user;
  uint32_t method;   /* sinew_rig_method */
  uint32_t category; /* sinew_category of SINEW_RIG_VOTES and of SINEW_RIG_SLOTS in published.h; else 0 */
  /* Model for fronts from sinew_rig_model_open(): it finds the front at any angle, and with SINEW_UP_AUTO whether y
   * or z is up. Null: SINEW_UP_AUTO is y, and the front is the one of four directions with the most certain votes */
  const sinew_model* front_model;
  uint32_t front;      /* sinew_front */
  uint32_t axes_known; /* 1: the mesh's file format has y up and +z front, which is used if the mesh is ambiguous */
} sinew_rig_options;

/* Outputs of rigging: the caller's arrays, each with room for SINEW_MAX_RIG_JOINTS, and numbers that the call writes.
 * Start from SINEW_INIT(sinew_rig_outputs). Parents come before their children; joint 0 is the root. Later versions
 * add members at the end, as in sinew_rig_options. */
typedef struct sinew_rig_outputs {
  uint32_t struct_size;        /* sizeof(sinew_rig_outputs) */
  uint32_t joint_count;        /* written: J, at least 1 */
  float* positions;            /* [J x 3] in the mesh's units and axes */
  int32_t* parents;            /* [J] -1 for the root */
  uint8_t* flags;              /* [J] for sinew_skeleton: SINEW_JOINT_NEVER for bone ends, else 0; null = not wanted */
  uint8_t* joint_classes;      /* [J] sinew_joint_class; a bone end's is its joint's; null = not wanted */
  int32_t* partners;           /* [J] mirror image of the joint: itself on the plane, -1 = none; null = not wanted */
  uint16_t* confidence;        /* [J] confidence of the joint's position, 0..32768; null = not wanted */
  uint16_t* parent_confidence; /* [J] confidence of its parent, 0..32768; null = not wanted */
  /* [J] unique names: Hips, Spine, LeftArm, ... Head_end; null = not wanted */
  char (*names)[SINEW_JOINT_NAME_BYTES];
  uint32_t mirrored; /* written: 1 if the skeleton is symmetric */
  /* written: axis nearest to the front: 0 = +z, 1 = +x, 2 = -z, 3 = -x, in axes with y up. Left is on the left of
   * that direction. If the front is exactly that axis, the mirror plane is across x for 0 and 2, else across z */
  uint32_t facing;
  /* written: position of the mirror plane on that axis, in the mesh's units; if `front` is between axes, on the
   * horizontal axis across it that has positive x */
  float plane;
  /* written: estimated mean error of the votes as a share of the longest side. Below about 0.03 the whole skeleton is
   * good, above 0.09 the votes are no better than SINEW_RIG_SHAPE. At least 0.1 for a sheet, whose surface nearly all
   * faces one direction or the opposite one */
  float spread;
  size_t used_bytes; /* written: high-water mark of the workspace */
  float front[3];    /* written: unit vector, the mesh's axes */
  uint32_t up;       /* written: sinew_up of the mesh, Y or Z */
  /* written: probability that `front` is right within 60 degrees, and that `up` is right, 0..1, with
   * sinew_rig_options::front_model. Calibrated on makers outside the training data; lower for a mesh without a mirror
   * plane; uncertain below 0.7. 1 if given by the caller; front_confidence is 0 without the model */
  float front_confidence, up_confidence;
} sinew_rig_outputs;

/* Checks a model for sinew_rig() (of bodies or of fronts) or for sinew_rig_details() (of hands), as
 * sinew_model_open() does for sinew_bind(), with the same return values. */
SINEW_API sinew_status sinew_rig_model_open(const void* bytes, size_t size_bytes, sinew_model* model);

/* Returns the bytes that sinew_rig() needs for meshes of at most these counts. A pure function of its arguments: the
 * same on every host.
 *   options     null = all defaults
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, or like sinew_rig() SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION, SINEW_ERROR_MODEL_TASK or
 * SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_rig_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                                uint32_t corner_count, const sinew_rig_options* options,
                                                size_t* size_bytes);

/* Predicts a skeleton. The same bytes on every platform, for any kernel and any order of vertices and faces.
 *   mesh       any topology; without faces only its vertices are used
 *   options    null = all defaults
 *   workspace  scratch, 64-byte aligned, size from sinew_rig_workspace_size(); its content is undefined afterwards
 *   outputs    positions and parents must be set
 *
 * Overlap and threads: as for sinew_bind().
 *
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, the model is not open, struct_size is too small or
 *                           above 4096, or an option is out of range
 *   SINEW_ERROR_NOT_BUILT   the library was built without a requested feature
 *   SINEW_ERROR_VERSION     a member unknown to this library is not 0
 *   SINEW_ERROR_MODEL_TASK  the model is for another task: sinew_model::task is not 1, or feature_set is 2 (hands); or
 *                           front_model is not for fronts (feature_set 5)
 *   SINEW_ERROR_COUNT       no vertex, a count above the limits in sinew/types.h, or fewer than two corners per face
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
  SINEW_DETAIL_PROPS = 4  /* objects held in hands; needs no model */
} sinew_rig_detail;

/* Returns the bytes that sinew_rig_details() needs for meshes of at most these counts and any skeleton, like
 * sinew_rig_workspace_size(). */
SINEW_API sinew_status sinew_rig_details_workspace_size(const sinew_model* hands_model, uint32_t vertex_count,
                                                        uint32_t face_count, uint32_t corner_count, uint32_t wanted,
                                                        const sinew_rig_options* options, size_t* size_bytes);

/* Adds joints for details of the mesh. The same bytes on every platform and for any kernel. In this order:
 *   HANDS  Each hand is cut out of the mesh and rigged separately. A hand is a leaf of class SINEW_CLASS_HAND with a
 *          parent, not counting bone ends. It gets as many fingers as the mesh has, and none if the votes disagree:
 *          mittens, fists, paws. A finger has two or three joints and a bone end, of the classes SINEW_CLASS_THUMB to
 *          SINEW_CLASS_PINKY. Their names begin with the first 20 letters of the hand's name: LeftHandThumb1,
 *          LeftHandThumb3_end. They replace a bone end of the hand. Of two mirrored hands the left one is rigged and
 *          the right one mirrored
 *   FACE   Heads, joints of SINEW_CLASS_HEAD, get children LeftEye and RightEye (SINEW_CLASS_EYE) at the centers of
 *          two separate spherical parts of the mesh in the position of eyes. Upright heads get Jaw at its center of
 *          rotation and the bone end Jaw_end at the chin (SINEW_CLASS_JAW), derived from the eyes. Heads whose eyes
 *          are painted or part of the skin, or that have an eye or a jaw, are unchanged
 *   PROPS  A hand that holds a separate part of the mesh gets a joint of SINEW_CLASS_PROP for it, to bind it as a
 *          rigid child. Such a part begins at the hand, reaches far beyond it and stays clear of the arm.
 *          RightHandProp is at its point nearest to the hand, the bone end RightHandProp_end at the farthest. A hand
 *          with a prop is unchanged
 * Duplicate names get a number. Hands and heads are unchanged if there is no room for their joints.
 *   hands_model  model for hands from sinew_rig_model_open(); null without SINEW_DETAIL_HANDS
 *   wanted       sinew_rig_detail bits, at least one
 *   options      those of sinew_rig(), of which up, weights_in_place, kernel and progress are used; null = all
 *                defaults
 *   outputs      in: joint_count, positions, parents and joint_classes from sinew_rig(), possibly edited; mirrored,
 *                facing, plane, front and up from it (front all 0: by `facing`); partners, flags and names if set.
 *                Each array has room for SINEW_MAX_RIG_JOINTS. out: the same with new joints at the end, or instead
 *                of a hand's bone end; used_bytes
 *
 * Overlap and threads: as for sinew_bind().
 *
 * Returns SINEW_OK, or with outputs untouched the errors of sinew_rig(), and
 *   SINEW_ERROR_ARGUMENT    joint_classes is null, or `wanted` is 0 or has other bits
 *   SINEW_ERROR_MODEL_TASK  the model is not for hands: sinew_model::task is not 1 or feature_set is not 2
 *   SINEW_ERROR_COUNT       joint_count is 0 or above SINEW_MAX_RIG_JOINTS
 *   SINEW_ERROR_INDEX       a parent does not come before its child, or a partner does not exist
 *   SINEW_ERROR_NOT_FINITE  a joint's position is NaN or infinite
 * sinew_rig() rejects a model for hands with SINEW_ERROR_MODEL_TASK. */
SINEW_API sinew_status sinew_rig_details(const sinew_model* hands_model, const sinew_mesh* mesh, uint32_t wanted,
                                         const sinew_rig_options* options, void* workspace, size_t workspace_bytes,
                                         sinew_rig_outputs* outputs);

#ifdef __cplusplus
}
#endif
#endif
