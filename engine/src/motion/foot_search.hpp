// SPDX-License-Identifier: MIT
// Where the source's feet stand, and how high feet are over their floors.
#ifndef SINEW_MOTION_FOOT_SEARCH_HPP
#define SINEW_MOTION_FOOT_SEARCH_HPP

#include "motion/clip_scene.hpp"

namespace sinew::motion {

// Frame rate of the limits of a foot's speed: a distance from one frame to the next is multiplied by
// the clip's rate over this one.
constexpr double kContactFps = 30;

struct FootHeights {
  double source = 0, target = 0;  // of the lowest point above the floor, each in its own units
};

class FootSearch {
 public:
  // The scene must be open and outlive this.
  explicit FootSearch(ClipScene* scene);

  // The toe, or the ankle of a leg without one.
  uint32_t sole_joint(const Limb& limb) const { return limb.toe >= 0 ? static_cast<uint32_t>(limb.toe) : limb.last; }
  // standing [frames]: 1 where ankle or toe is low and the toe is slow. Poses the source.
  void find_standing(const Limb& limb, uint8_t* standing);
  // The foot's, in the source's pose.
  bool is_low(const Limb& limb) const;
  // A displacement of the source between frames that counts as none.
  bool is_slow(Vec3d way) const;
  // Height of the source's floor, in its units.
  double source_floor() const { return source_floor_; }
  // How far a foot's ankle or toe is over its standing height, the lower one, in the source's pose.
  double height(const Limb& limb) const { return lesser(lift(limb.last), lift(sole_joint(limb))); }
  // Heights of the bodies' vertices in their current poses. Without a source's body: how far the joints are above
  // where they are at rest.
  FootHeights lowest(const Limb& limb, uint32_t number) const;

 private:
  uint32_t source_of(uint32_t t) const { return static_cast<uint32_t>(s_.plan->map[t]); }
  double lift(uint32_t t) const;

  ClipScene& s_;
  double source_floor_ = 0;
};

}  // namespace sinew::motion
#endif
