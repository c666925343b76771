// SPDX-License-Identifier: MIT
// Contacts of a whole clip: feet that stand stay where they stand, what else is on the floor is on it, hands that touch the body touch
// the same spot, and arms stay out of it. Works on frames that were copied, round by round, since each round smooths over time.
#ifndef SINEW_MOTION_CONTACTS_HPP
#define SINEW_MOTION_CONTACTS_HPP

#include "motion/arm_search.hpp"
#include "motion/floor_contacts.hpp"

namespace sinew::motion {

constexpr uint32_t kNearTriangles = 24;
constexpr uint32_t kFeetEnd = 250;  // permille of the progress, when the feet are done and the hands begin

// Where a hand of the source is, seen from its body.
struct HandContact {
  uint32_t vertex = 0;  // of the hand, that nearest to the body
  double alpha = 0;     // 0: far from it, 1: touches
  uint32_t count = 0;   // of triangles near that vertex, nearest first
  uint32_t triangles[kNearTriangles] = {};
  double shares[kNearTriangles] = {};  // sum 1
  Vec3d offsets[kNearTriangles] = {};  // of the vertex from the triangle's middle, in the triangle's own axes
  double depth = 0;                    // of the deepest point of hand and forearm under the rest of the body
  double beyond = 0;                   // how much deeper the target's arm is than it may be
  Vec3d normal = {0, 0, 0};            // of the body over that arm's deepest point
  Vec3d way = {0, 0, 0};  // out of the body for the whole arm, of length 1 or 0, where no body moves the source
  bool outside = false;   // the target's arm in its current pose is no deeper than allowed
};

struct ContactScene : FloorScene {
  ArmSearch search;
  TriangleTree source_tree, target_tree;
  HandContact* hands = nullptr;  // [frames x arms]

  // Works with a measuring arena. Returns arena.ok().
  bool allocate_all(Arena& arena, uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles,
                    uint32_t frames);
  // As load_source(), pose_target() and pose_target_at_rest() of the bodies, with their trees.
  void search_source(uint32_t frame);
  void search_target(uint32_t frame, bool only_deepest);
  void search_target_at_rest();
};

// State between frames that come one by one.
struct HandMemory {
  double rest_depths[kMostArms] = {};  // of arms in the target's body at rest, where no body moves the source; once
  // In the axes of the arm's parent: distance that it was moved to the body and out of it, and the direction.
  Vec3d touches[kMostArms] = {}, pushes[kMostArms] = {}, ways[kMostArms] = {};
  bool any = false;  // a frame came before
};

// SINEW_OK or SINEW_ERROR_CANCELLED.
sinew_status place_hands(ContactScene* scene);
// For a scene with an open search: the constant part, then its frame alone. The displacement of an arm out of the
// body fades afterwards.
void open_hands(ContactScene* scene, HandMemory* memory);
void place_hands_next(ContactScene* scene, HandMemory* memory);

// Behind sinew_retarget_contacts(); the caller has checked pointers and the source's body against the target's.
size_t measure_contacts(uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles,
                        uint32_t frames);
sinew_status run_contacts(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body& target,
                          const ClipInputs& inputs, Arena& arena);
// Behind sinew_retarget_keep_range(), in memory of the same size.
sinew_status keep_range(sinew_retarget* plan, const sinew_motion_body& target, const ClipInputs& inputs, Arena& arena);

// Behind sinew_retarget_measure() and sinew_retarget_spots(), in memory of the same size. `limbs` [kMostLimbs]; `spots` [frames x
// kMostLimbs] or null.
sinew_status measure_clip(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body& target,
                          const ClipInputs& inputs, Arena& arena, sinew_limb_quality* limbs, uint32_t* limb_count,
                          sinew_contact_spot* spots);

}  // namespace sinew::motion
#endif
