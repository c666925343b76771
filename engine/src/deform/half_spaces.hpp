// SPDX-License-Identifier: MIT
// Contact in bends: where a joint folds, each side of the skin stays on its side of the plane that halves the angle.
#ifndef SINEW_DEFORM_HALF_SPACES_HPP
#define SINEW_DEFORM_HALF_SPACES_HPP

#include "core/threads.hpp"
#include "deform/posed_joints.hpp"

namespace sinew::deform {

constexpr uint32_t kPiece = 512;  // vertices or nodes that a thread takes at once

// A vertex stays where normal . x >= offset. Without one the normal is 0.
struct HalfSpace {
  Vec3d normal;   // unit vector
  double offset;  // the caller's units, the common scale divided out
  bool set() const { return normal.x != 0 || normal.y != 0 || normal.z != 0; }
};

// How far x is outside, negative, or 0.
inline double outside_by(const HalfSpace& half, Vec3d x) {
  if (!half.set()) return 0;
  const double distance = dot(half.normal, x) - half.offset;
  return distance < 0 ? distance : 0;
}

// Fills spaces [V]. planes [J] is scratch.
struct BendPlane {
  uint32_t joint;
  Vec3d rest_normal, normal, center;  // of the plane at rest and posed; it passes the posed joint
  double reach;                       // 0: the joint does not fold
  double slack;                       // how far beyond the plane vertices may be: it falls to 0 while a fold begins
};
void find_half_spaces(const PosedJoints& posed, const Threads& threads, BendPlane* planes, HalfSpace* spaces);

}  // namespace sinew::deform
#endif
