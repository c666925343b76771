/* SPDX-License-Identifier: MIT
 * Joint names: derives class, side, role and mirror partner of joints from their names, and gives the names of
 * conventions. One table of words serves all calls and front-ends: engine/src/names/words.cpp. */
#ifndef SINEW_NAMES_H
#define SINEW_NAMES_H

#include "sinew/rig.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Role of a joint. Numbers are never reused. */
typedef enum sinew_joint_role {
  SINEW_ROLE_DEFORMS = 0, /* moves the mesh; the default for unknown joints */
  SINEW_ROLE_ROOT = 1,    /* carries the whole rig */
  SINEW_ROLE_CONTROL = 2, /* handle, pole or target that other joints follow */
  SINEW_ROLE_SLOT = 3,    /* attachment point for weapons, hats and other objects */
  SINEW_ROLE_END = 4,     /* marks the end of a bone; exporters may add or drop such joints */
  SINEW_ROLE_TWIST = 5,   /* this and the next are details, which move the mesh: half of a limb */
  SINEW_ROLE_FACE = 6,    /* part of a face */
  SINEW_ROLE_FINGER = 7,  /* finger or bone of a palm */
  SINEW_ROLE_HELPER = 8   /* helps its parent */
} sinew_joint_role;

/* Whether vertices follow a joint. */
typedef enum sinew_follows {
  SINEW_FOLLOWS_UNKNOWN = 0,
  SINEW_FOLLOWS_SOME = 1, /* it has weight */
  SINEW_FOLLOWS_NONE = 2  /* it has none, or is far from any mesh */
} sinew_follows;

/* Outputs of sinew_joint_classes(): the caller's arrays, null = not wanted, and numbers that the call writes. Start
 * from SINEW_INIT(sinew_joint_verdicts). */
typedef struct sinew_joint_verdicts {
  uint32_t struct_size; /* sizeof(sinew_joint_verdicts) */
  uint32_t mirror_axis; /* written: axis across the mirror plane, 0 = x; needs parents and positions */
  uint8_t* classes;     /* [J] sinew_joint_class; a bone end's is its joint's */
  uint8_t* roles;       /* [J] sinew_joint_role */
  int8_t* sides;        /* [J] 1 left, -1 right, 0 unknown */
  int32_t* numbers;     /* [J] for a finger's joint its index in the finger from 1, else the number at the end of its
                      * name, without those that tools append (_021, .001); -1 = none */
  int32_t* partners;    /* [J] joint with the same name on the other side, -1 = none */
  int32_t* images;      /* [J] joint at its mirrored position, within 0.5 % of the longest side: its partner or, without
                      * one, any; itself on the plane; -1 = none */
  float mirror_planes[3]; /* written: position of the plane across each axis: midway between partners, else at the
                           * center of all joints */
  uint32_t mirrored;      /* written: 1 if every joint has an image and the parents are images too */
} sinew_joint_verdicts;

/* Returns the bytes that sinew_joint_classes() needs for at most this many joints. A pure function of its argument:
 * the same on every host.
 * Returns SINEW_OK, or with *size_bytes 0 SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_joint_classes_workspace_size(uint32_t joint_count, size_t* size_bytes);

/* Classifies joints by name. A name is split into words: HandIK.L is hand, ik, l. A prefix or a control word in most
 * names is ignored, and a control in the middle of a limb is a limb. Leaves called end, ends or site are bone ends,
 * and so are those called nub or null if no vertex follows them; a tip is an ordinary joint. The same on every
 * platform.
 *   skeleton   names must be set, a null name is unknown; parents may be null: no bone ends or halves of legs are
 *              found; positions may be null: controls and partners are found by name only. ends mark joints that
 *              nothing follows
 *   follows    [J] sinew_follows, null = unknown. A joint that a vertex follows deforms, whatever its name, and a
 *              leaf that nothing follows is an end
 *   workspace  scratch, 64-byte aligned, size from sinew_joint_classes_workspace_size()
 *
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, or a value of
 *                           follows is out of range
 *   SINEW_ERROR_NOT_BUILT   the library was built without it (SINEW_SMALL_CODE)
 *   SINEW_ERROR_VERSION     a member unknown to this library is not 0
 *   SINEW_ERROR_COUNT       no joint or more than SINEW_MAX_JOINTS
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position is NaN or infinite
 *   SINEW_ERROR_INDEX       a parent does not exist
 *   SINEW_ERROR_HIERARCHY   parents form a cycle */
SINEW_API sinew_status sinew_joint_classes(const sinew_skeleton* skeleton, const uint8_t* follows, void* workspace,
                                           size_t workspace_bytes, sinew_joint_verdicts* verdicts);

/* Returns the bytes that sinew_limb_classes() needs for rigs of at most these counts; source_count 0 = no source. A
 * pure function of its arguments. Returns SINEW_OK, or with *size_bytes 0 SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_limb_classes_workspace_size(uint32_t target_count, uint32_t source_count,
                                                         size_t* size_bytes);

/* Finds arms, legs and other body parts of a rig, as input for sinew_retarget_create(): from names
 * (sinew_joint_classes()), else from the names of the joints' sources, else, if neither has an arm or a leg, by
 * fitting a human body to the rig.
 *   source, sources  a rig and [target J] the joint of it that drives each joint, -1 = none; null, null = unknown
 *   classes          out [target J] sinew_joint_class, SINEW_CLASS_OTHER for ends, details and unknown joints
 *   workspace        scratch, 64-byte aligned, size from sinew_limb_classes_workspace_size()
 *
 * Returns SINEW_OK, or with classes untouched the errors of sinew_map(); SINEW_ERROR_RANGE if a source does not
 * exist. */
SINEW_API sinew_status sinew_limb_classes(const sinew_skeleton* target, const sinew_skeleton* source,
                                          const int32_t* sources, void* workspace, size_t workspace_bytes,
                                          uint8_t* classes);

/* Returns 1 for left, -1 for right, 0 for a name without a side: LeftArm, arm_l, Arm.L, L_Arm, l-arm, LHipJoint,
 * lhand. */
SINEW_API int32_t sinew_joint_side(const char* name);

/* Exchanges the side in a name; a name without a side is copied.
 *   other  out, [room], zero-terminated
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT for a null pointer, or SINEW_ERROR_WORKSPACE if `room` is too small. */
SINEW_API sinew_status sinew_joint_other_side(const char* name, char* other, size_t room);

/* Naming conventions. Numbers are never reused. */
typedef enum sinew_naming {
  SINEW_NAMING_SINEW = 0, /* Hips, Spine, LeftArm: of sinew_rig() */
  SINEW_NAMING_MIXAMO = 1,
  SINEW_NAMING_VRM = 2,
  SINEW_NAMING_UNREAL = 3,
  SINEW_NAMING_RIGIFY = 4,
  SINEW_NAMING_MAKEHUMAN = 5
} sinew_naming;

/* Returns "sinew", "mixamo", ...; null after the last. */
SINEW_API const char* sinew_naming_text(uint32_t naming);

/* Gives the name of a joint in a convention.
 *   joint_class  sinew_joint_class
 *   side         1 left, -1 right; ignored for classes in the middle
 *   index        0 for the first of a chain or finger, 1 for the next
 *   name         out, [SINEW_JOINT_NAME_BYTES]
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT for a null pointer or an unknown naming or side, or SINEW_ERROR_RANGE if the
 * convention has no such joint; name is untouched on failure. */
SINEW_API sinew_status sinew_joint_standard_name(uint32_t naming, uint32_t joint_class, int32_t side, uint32_t index,
                                                 char* name);

#ifdef __cplusplus
}
#endif
#endif
