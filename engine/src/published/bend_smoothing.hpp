// SPDX-License-Identifier: MIT
// Smoothing of a posed surface where joints bend, for the end of the published correction.
#ifndef SINEW_PUBLISHED_BEND_SMOOTHING_HPP
#define SINEW_PUBLISHED_BEND_SMOOTHING_HPP

#include "deform/posed_joints.hpp"

namespace sinew::deform {

struct SmoothedVertex {
  Quaternion rotation;  // of the joints' blend
  double share;         // of a step, 0 where nothing bends
  Vec3d position, next;
  uint32_t joint;  // whose bend it belongs to, J for none
  Vec3d normal;    // as long as twice the area around it
};

// The bend of a joint as a body: the cones of its triangles from the joint. The rims of both sides move with a bone each and
// the joint lies on both, so that nothing but the bend itself changes the sum.
struct BendVolume {
  double at_rest, now;  // six volumes
  double area;          // what a step of 1 of all its vertices adds, likewise
};

// A vertex moves towards its neighbors' rest offsets, rotated by the joints: what the pose displaced is
// smoothed, and the rest pose is smooth already. The share of a step grows with the angle between the joints of a vertex and is 0 where
// they do not rotate against each other. Every step that shrinks is followed by one that inflates, after G. Taubin, "A signal processing
// approach to fair surface design", 1995; the last ones along the normals, by what the bend of a joint lacks of its volume at rest.
// As drawn a vertex goes towards the mean of its neighbors, once, by its share, and that is all.
// positions [V] in and out; moved [U]: what the lattice moved, which is the whole of a bend; vertices [U] and volumes [J] are scratch.
void smooth_bends(const PosedJoints& posed, const uint8_t* moved, SmoothedVertex* vertices, BendVolume* volumes,
                  Vec3d* positions);

}  // namespace sinew::deform
#endif
