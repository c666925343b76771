// SPDX-License-Identifier: MIT
// Contacts of feet, hands, knees, elbows, seat and chest with the floor, for a whole clip or a stream of frames.
#ifndef SINEW_MOTION_FLOOR_CONTACTS_HPP
#define SINEW_MOTION_FLOOR_CONTACTS_HPP

#include "motion/floor_patches.hpp"
#include "motion/foot_search.hpp"
#include "motion/natural_range.hpp"

namespace sinew::motion {

struct FloorScene : ClipScene {
  Vec3d* moves = nullptr;       // [frames x limbs] where ends are to go from where they are
  Vec3d* smooth = nullptr;      // [frames] scratch
  Vec3d* lifts = nullptr;       // [frames] of the torso, see BodyLift; then scratch
  uint8_t* standing = nullptr;  // [frames] scratch
  double* heights = nullptr;    // [frames] scratch
  FloorPatches floor_patches;

  // The memory that this adds to ClipScene. Works with a measuring arena. Returns arena.ok().
  bool allocate_floor(Arena& arena, uint32_t target_joints, uint32_t vertices, uint32_t frames);
};

// x[i] becomes (x[i-1] + 2 x[i] + x[i+1]) / 4, ends stay. stride in elements; scratch [count].
void smooth_over_time(Vec3d* values, uint32_t count, uint32_t stride, uint32_t passes, Vec3d* scratch);

constexpr double kFade = 0.6;  // of an offset, what is left after a thirtieth of a second
// And after a frame: `share` to the power of 30 / fps, by whole powers and roots of it, which need no libm.
double fade_at(double fps, double share);

// A joint that is held where it stands: the ankle with its foot, the wrist with its hand, a knee or an elbow.
struct HeldJoint {
  uint32_t limb = 0;
  uint32_t joint = 0;  // that stays at one position
  uint32_t patch = 0;  // of the body, beside feet
  bool foot = false, middle = false;
};

// State between frames that come one by one.
struct FloorMemory {
  struct Anchor {
    Vec3d source = {0, 0, 0};    // of the source's joint
    Vec3d position = {0, 0, 0};  // of the target's, over the floor, while it stands
    Vec3d offset = {0, 0, 0};    // from where it was copied
    bool is_locked = false;
  };
  Anchor anchors[2 * kMostLimbs];  // of ends, then of middles
  Vec3d bends[kMostLimbs] = {};
  Hinge hinges[kMostLimbs];  // of find_hinges(), once
  bool any = false;          // a frame came before
};

class FloorContacts {
 public:
  // The scene must be open. With a memory its clip is the next frame alone: what stands stays where it came to stand,
  // not at the mean of the frames that it stands, and nothing is smoothed. Both must outlive this.
  FloorContacts(FloorScene* scene, FloorMemory* memory);
  void run();

 private:
  static size_t index(uint32_t frame, uint32_t limb) { return size_t{frame} * kMostLimbs + limb; }
  double weight(uint32_t frame, uint32_t patch) const { return s_.floor_patches.at(frame, patch).weight; }
  FloorMemory::Anchor& anchor_of(const HeldJoint& held) const {
    return memory_->anchors[held.middle ? kMostLimbs + held.limb : held.limb];
  }

  SINEW_RARE void find_bends();
  void hold(const HeldJoint& held, bool again);
  void find_standing(const HeldJoint& held);
  bool is_on_floor(const HeldJoint& held) const;
  double rise_of(const HeldJoint& held, uint32_t frame);
  SINEW_RARE void aim(const Limb& limb, Vec3d move);
  SINEW_RARE void reach(const HeldJoint& held, Vec3d move, uint32_t frame);
  SINEW_RARE Vec3d within_reach(const Limb& limb, Vec3d goal) const;
  void find_flat(const HeldJoint& held);
  void lock(const HeldJoint& held);
  SINEW_RARE void lock_next(const HeldJoint& held, bool again);
  void fade(uint32_t number);
  void reach_floor(const Limb& limb, uint32_t number);
  void add_heights(uint32_t number);

  FloorScene& s_;
  FloorMemory* memory_;
  sinew_retarget& plan_;
  FootSearch search_;
  Vec3d bends_[kMostLimbs];  // see find_bends()
};

}  // namespace sinew::motion
#endif
