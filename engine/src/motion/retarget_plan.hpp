// SPDX-License-Identifier: MIT
// Constants of a pair of skeletons and a map, found once: how the source's world is rotated, which bones are long
// ones of limbs and how far their rest poses are apart, how much larger the target is, and what stands on the floor.
#ifndef SINEW_MOTION_RETARGET_PLAN_HPP
#define SINEW_MOTION_RETARGET_PLAN_HPP

#include "motion/motion_rig.hpp"

// The type of the interface: the plan is one block of memory, this is its beginning.
struct sinew_retarget {
  sinew::motion::MotionRig source, target;
  int32_t* map = nullptr;        // [target joints] source joint or -1
  uint8_t* classes = nullptr;    // [target joints] sinew_joint_class
  int32_t* long_ends = nullptr;  // [target joints] where a limb's long bone that begins here ends, else -1
  int32_t* carriers = nullptr;   // [target joints] calf or forearm that a foot or hand beside it goes with, else -1
  sinew::motion::Quat* align =
      nullptr;                  // [target joints] from the target's rest direction of its long bone to the source's
  uint8_t* moved = nullptr;     // [target joints] 1 below `mover`, itself included
  uint32_t* anchors = nullptr;  // [anchor_count] target joints whose middle goes where that of their sources goes
  uint32_t* floor_joints = nullptr;  // [floor_count] target joints the lowest of which stands on the floor
  uint32_t anchor_count = 0, floor_count = 0;
  bool has_legs = false;
  int32_t mover = -1;                                         // target joint that takes the translation
  sinew::motion::Quat rotation = sinew::motion::kNoRotation;  // from the source's world to the target's
  sinew::Vec3d up = {0, 1, 0};                                // of the target's world
  double scale = 1;                                           // lengths of the target per length of the source
  double flight_scale =
      1;  // the same of heights over the floor while nothing is on it: by the whole bodies where legs are shorter
  double source_floor = 0;   // height of the floor joints' sources at rest, the source's units
  double source_lowest = 0;  // of all its joints
  double leg_length = 0;     // of the source; without legs its extent
  double target_floor = 0;   // height of the floor joints at rest
  double arm_spread = 0;     // degrees
  bool node_offsets = false;
  bool in_place = false;
  bool translations = false;
  bool same_rig = false;  // mapped joints lie as their sources do: nothing is left to be mended
  // Scratch of a frame: rotated against the rest pose, and where; the source's in the target's world.
  sinew::motion::Quat* source_rotations = nullptr;
  sinew::Vec3d* source_positions = nullptr;
  sinew::motion::Quat* target_rotations = nullptr;
  sinew::Vec3d* target_positions = nullptr;
};

namespace sinew::motion {

// The options of the interface, checked.
struct RetargetOptions {
  bool node_offsets = false, in_place = false, translations = false;
  double scale = 0, arm_spread = 0;
  uint32_t source_up = SINEW_UP_AUTO, target_up = SINEW_UP_AUTO;  // create_plan() takes them from the skeletons
};
// Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_VERSION.
sinew_status read_retarget_options(const sinew_retarget_options* options, RetargetOptions* out);

// Bytes of a plan, what it needs while it is made included.
size_t measure_plan(uint32_t source_joints, uint32_t target_joints);

// As sinew_retarget_create() after its checks of pointers, counts and memory.
sinew_status create_plan(const sinew_skeleton& source, const sinew_skeleton& target, const int32_t* map,
                         const uint8_t* classes, const RetargetOptions& options, void* memory, size_t memory_bytes,
                         sinew_retarget** plan);

// A body may consist of several roots: sets parents and order of a plan's target by its map and classes. A root whose
// source is attached to the body is attached to the same joint here; a root without a source to the body's nearest
// joint, and a hand or foot beside its limb to that limb. `scratch` [2 target joints + 1].
void hang_roots(sinew_retarget* plan, uint32_t* scratch);

// The class whose long bone ends at a joint of this class; SINEW_CLASS_OTHER: none does.
uint32_t class_before(uint32_t joint_class);

// The root with the most mapped joints below it: sockets and props may be roots of their own. `counts` [target joints] is scratch.
uint32_t busiest_root(const sinew_retarget& plan, uint32_t* counts);

// Sets up and rotation of a plan whose map, anchors and floor joints are found.
void find_worlds(const RetargetOptions& options, sinew_retarget* plan);

}  // namespace sinew::motion
#endif
