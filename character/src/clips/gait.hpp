// SPDX-License-Identifier: MIT
// A foot over one cycle of a gait: rolled over heel and ball while it stands, carried to the next footprint in between.
#ifndef SINEW_CHARACTER_CLIPS_GAIT_HPP
#define SINEW_CHARACTER_CLIPS_GAIT_HPP

#include <functional>

#include "clips/puppet.hpp"

namespace sinew::clips {

// Points of a foot at rest, flat on the floor.
struct FootShape {
  Point3 ankle, heel, ball;
};

struct FootPose {
  Point3 ankle;
  double pitch = 0;  // degrees, toes down
  double toes = 0;   // degrees of the toes in the world
};

struct FootPath {
  double stance = 0.6;  // share of the cycle
  double stride = 1;    // what the body travels in one
  double front = 0;     // where the foot stands, flat, against its position at rest, when the stance begins
  double lift = 0;      // height that the ankle is carried higher than it leaves and lands
  std::function<double(double phase)> pitch;
};

// In the frame that travels with the body. While it stands the foot moves back as fast as that travels, so its pivot stays in place.
FootPose foot_at(const FootPath& path, const FootShape& shape, double phase);

}  // namespace sinew::clips
#endif
