// SPDX-License-Identifier: MIT
// Contacts of a whole clip: feet that stand stay where they stand, hands that touch the body touch the same place, and arms
// stay out of it. Works on frames that were copied, round by round, since each round smooths over time.
#ifndef SINEW_MOTION_CONTACTS_HPP
#define SINEW_MOTION_CONTACTS_HPP

#include "core/counts.hpp"
#include "motion/limbs.hpp"
#include "motion/posed_body.hpp"

namespace sinew {

// What a vertex of the target belongs to.
enum class BodyPart : uint8_t { kOther, kUpperArm, kForearm, kHand, kFoot };

constexpr uint32_t kNearTriangles = 24;
constexpr uint32_t kMostArms = 4;  // that are kept in touch and out of the body

// Where a hand of the source is, seen from its body.
struct HandContact {
  uint32_t vertex = 0;  // of the hand, that nearest to the body
  double alpha = 0;     // 0: far from it, 1: touches
  uint32_t count = 0;   // of triangles near that vertex, nearest first
  uint32_t triangles[kNearTriangles] = {};
  double shares[kNearTriangles] = {};  // sum 1
  Vec3d offsets[kNearTriangles] = {};  // of the vertex from the triangle's middle, in the triangle's own axes
  double depth = 0;                    // of the deepest point of hand and forearm under the rest of the body
};

struct ContactInputs {
  uint32_t frames = 0;
  const float* source_rotations = nullptr;     // [frames x source joints x 4]
  const float* source_translations = nullptr;  // [frames x source joints x 3]
  double ground = 0, fps = 30;
  float* rotations = nullptr;     // [frames x target joints x 4]
  float* translations = nullptr;  // [frames x target joints x 3]
  Progress progress = {};
};

// What all of it shares.
struct ContactScene {
  sinew_retarget* plan = nullptr;
  const ContactInputs* in = nullptr;
  const sinew_motion_body* body = nullptr;  // the target's
  bool has_source = false;
  PosedBody source, target;
  LimbList limbs;
  BodyPart* parts = nullptr;         // [vertices]
  uint8_t* limb_of = nullptr;        // [vertices] index into limbs, kMostLimbs: none
  uint32_t* picked = nullptr;        // [triangles] scratch
  uint32_t* arm_vertices = nullptr;  // [vertices] of hands and forearms
  Vec3d* moves = nullptr;            // [frames x limbs] where ends are to go from where they are
  Vec3d* smooth = nullptr;           // [frames] scratch
  uint8_t* stands = nullptr;         // [frames] scratch
  double* heights = nullptr;         // [frames] scratch
  HandContact* hands = nullptr;      // [frames x arms]
  double source_height = 0;          // of the source's body, in its units
  // A frame of the source, and its body where there is one; of the target, without it.
  sinew_status load_source(uint32_t frame, bool with_body);
  void load(uint32_t frame);
  void store(uint32_t frame) const;
};

// x[i] becomes (x[i-1] + 2 x[i] + x[i+1]) / 4, ends stay. stride in elements; scratch [count].
void smooth_over_time(Vec3d* values, uint32_t count, uint32_t stride, uint32_t passes, Vec3d* scratch);

// SINEW_OK, SINEW_ERROR_NOT_FINITE or SINEW_ERROR_CANCELLED.
sinew_status hold_feet(ContactScene* scene);
sinew_status place_hands(ContactScene* scene);

// Behind sinew_retarget_contacts(); the caller has checked pointers and the source's body against the target's.
size_t measure_contacts(uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles,
                        uint32_t frames);
sinew_status run_contacts(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body& target,
                          const ContactInputs& inputs, Arena& arena);

}  // namespace sinew
#endif
