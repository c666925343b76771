/* SPDX-License-Identifier: MIT
 * Names: what joints are, by what they are called: class, side, role, mirror partner; and what conventions call them. One
 * table of words for every call of the library and every front-end: engine/src/names/words.cpp. */
#ifndef SINEW_NAMES_H
#define SINEW_NAMES_H

#include "sinew/rig.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a joint is there for. Numbers are never reused. */
typedef enum sinew_joint_role {
  SINEW_ROLE_DEFORMS = 0, /* moves the mesh, as far as anyone can tell */
  SINEW_ROLE_ROOT = 1,    /* carries the whole rig */
  SINEW_ROLE_CONTROL = 2, /* handle, pole or target that other joints follow */
  SINEW_ROLE_SLOT = 3,    /* where weapons, hats and other things are attached */
  SINEW_ROLE_END = 4,     /* says where a bone ends; exporters write and drop such joints as they like */
  SINEW_ROLE_TWIST = 5,   /* from here on details, which move the mesh: half of a limb */
  SINEW_ROLE_FACE = 6,    /* part of a face */
  SINEW_ROLE_FINGER = 7,  /* finger or bone of a palm */
  SINEW_ROLE_HELPER = 8   /* helps the joint above it */
} sinew_joint_role;

/* Whether a vertex follows a joint. */
typedef enum sinew_follows {
  SINEW_FOLLOWS_UNKNOWN = 0,
  SINEW_FOLLOWS_SOME = 1, /* it has weight */
  SINEW_FOLLOWS_NONE = 2  /* it has none, or stands where no mesh is near */
} sinew_follows;

/* What a call gives: the caller's arrays, null = not wanted, and numbers that the call writes. Start from
 * SINEW_INIT(sinew_joint_verdicts). */
typedef struct sinew_joint_verdicts {
  uint32_t struct_size; /* sizeof(sinew_joint_verdicts) */
  uint32_t mirror_axis; /* written: that the mirror plane is across, 0 = x; needs parents and positions */
  uint8_t* classes;     /* [J] sinew_joint_class; a bone end's is its joint's */
  uint8_t* roles;       /* [J] sinew_joint_role */
  int8_t* sides;        /* [J] 1 left, -1 right, 0 not said */
  int32_t* numbers;  /* [J] of a finger's joint its index in the finger from 1, else the number that its name ends with
                         * but for those that tools append (_021, .001); -1 without one */
  int32_t* partners; /* [J] the joint of the same name on the other side, -1 without one */
  int32_t* images;   /* [J] the joint that stands where its mirror image is, within 0.5 % of the longest side: its
                         * partner or, where it has none, any; itself on the plane; -1 without one */
  float mirror_planes[3]; /* written: where a plane across each axis is: amid partners, else amid all joints */
  uint32_t mirrored;      /* written: 1 where every joint has an image and parents are images as well */
} sinew_joint_verdicts;

/* Bytes sinew_joint_classes() needs for at most so many joints. A pure function of its argument: the same on every host.
 * Returns SINEW_OK, or with *size_bytes 0 SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_joint_classes_workspace_size(uint32_t joint_count, size_t* size_bytes);

/* Says what joints are. Names are read as words: HandIK.L is hand, ik, l. A prefix that most names share says nothing, a
 * control word that most joints have in their names neither, and a control in the middle of a limb is a limb. Leaves
 * called end, ends or site end a bone, those called nub or null too unless a vertex follows them; a tip is a joint like
 * others. The same on every platform.
 *   skeleton   names must be set, a null name says nothing; parents may be null: no joint has an end or a leg's halves;
 *              positions may be null: names alone tell controls and partners. ends tell what nothing follows
 *   follows    [J] sinew_follows, null = not known. What a vertex follows deforms, whatever it is called, and a leaf that
 *              nothing follows is an end
 *   workspace  scratch, 64-byte aligned, size from sinew_joint_classes_workspace_size()
 *
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, or a value of
 *                           follows is out of its range
 *   SINEW_ERROR_NOT_BUILT   this build is without it (SINEW_SMALL_CODE)
 *   SINEW_ERROR_VERSION     a member behind those that this library knows is not 0
 *   SINEW_ERROR_COUNT       no joint or more than SINEW_MAX_JOINTS
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position is NaN or infinite
 *   SINEW_ERROR_INDEX       a parent is no joint
 *   SINEW_ERROR_HIERARCHY   parents form a cycle */
SINEW_API sinew_status sinew_joint_classes(const sinew_skeleton* skeleton, const uint8_t* follows, void* workspace,
                                           size_t workspace_bytes, sinew_joint_verdicts* verdicts);

/* Bytes sinew_limb_classes() needs for rigs of at most these counts; source_count 0 = no source. A pure function of its
 * arguments. Returns SINEW_OK, or with *size_bytes 0 SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_limb_classes_workspace_size(uint32_t target_count, uint32_t source_count,
                                                         size_t* size_bytes);

/* Which joints of a rig are arms, legs and other parts of a body: what sinew_retarget_create() wants to know of its target.
 * Names say it (sinew_joint_classes()), else those of the joints' sources, else, where both know no arm and no leg, a human
 * body that is laid over the rig.
 *   source, sources  a rig and [target J] the joint of it that a joint has its motion from, -1 = none; null, null = not known
 *   classes          out [target J] sinew_joint_class, SINEW_CLASS_OTHER for ends, details and what nobody knows
 *   workspace        scratch, 64-byte aligned, size from sinew_limb_classes_workspace_size()
 *
 * Returns SINEW_OK, or with classes untouched what sinew_map() does; SINEW_ERROR_RANGE where a source is no joint. */
SINEW_API sinew_status sinew_limb_classes(const sinew_skeleton* target, const sinew_skeleton* source,
                                          const int32_t* sources, void* workspace, size_t workspace_bytes,
                                          uint8_t* classes);

/* 1 for left, -1 for right, 0 for a name without a side: LeftArm, arm_l, Arm.L, L_Arm, l-arm, LHipJoint, lhand. */
SINEW_API int32_t sinew_joint_side(const char* name);

/* The name with its side exchanged, the same name where it has none.
 *   other  out, [room], 0 at its end
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT for a null pointer, or SINEW_ERROR_WORKSPACE where it has no room. */
SINEW_API sinew_status sinew_joint_other_side(const char* name, char* other, size_t room);

/* Whose names. Numbers are never reused. */
typedef enum sinew_naming {
  SINEW_NAMING_SINEW = 0, /* Hips, Spine, LeftArm: of sinew_rig() */
  SINEW_NAMING_MIXAMO = 1,
  SINEW_NAMING_VRM = 2,
  SINEW_NAMING_UNREAL = 3,
  SINEW_NAMING_RIGIFY = 4,
  SINEW_NAMING_MAKEHUMAN = 5
} sinew_naming;

/* "sinew", "mixamo", ...; null behind the last. */
SINEW_API const char* sinew_naming_text(uint32_t naming);

/* What a convention calls a joint.
 *   joint_class  sinew_joint_class
 *   side         1 left, -1 right; not read for classes in the middle
 *   index        0 for the first of a chain or finger, 1 for the next
 *   name         out, [SINEW_JOINT_NAME_BYTES]
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT for a null pointer or an unknown naming or side, or SINEW_ERROR_RANGE where the
 * convention has no such joint; name is untouched then. */
SINEW_API sinew_status sinew_joint_standard_name(uint32_t naming, uint32_t joint_class, int32_t side, uint32_t index,
                                                 char* name);

#ifdef __cplusplus
}
#endif
#endif
