// SPDX-License-Identifier: MIT
// Knees and elbows as hinges: to which side they bend, and how far.
#ifndef SINEW_MOTION_NATURAL_RANGE_HPP
#define SINEW_MOTION_NATURAL_RANGE_HPP

#include "motion/clip_scene.hpp"

namespace sinew::motion {

// A middle joint's range: the direction of the second bone in the axes of the first one's joint, which are the world's at rest.
struct Hinge {
  bool known = false;
  Vec3d along = {0, 0, 0};  // of the first bone, of length 1
  Vec3d side = {0, 0, 0};   // across it: direction that the second bone may rotate to
  double least_side = 0;    // smallest part of the second bone's direction along `side`
};

// [scene.limbs]. Sides by the front of the feet, else by how a limb is bent at rest; not known for what is straight without a
// front.
void find_hinges(const ClipScene& scene, Hinge (&hinges)[kMostLimbs]);

// In the plan's target pose. Out by more than a degree.
bool is_out_of_range(const sinew_retarget& plan, const Limb& limb, const Hinge& hinge);
// Rotates the second bone and its descendants into the range; the nearer the pose is to it, the less, so that nothing
// pops. False: it is there.
bool bend_into_range(const Limb& limb, const Hinge& hinge, sinew_retarget* plan);
// All limbs of a frame.
void keep_range_of_frame(ClipScene& scene, const Hinge (&hinges)[kMostLimbs], uint32_t frame);

}  // namespace sinew::motion
#endif
