// SPDX-License-Identifier: MIT
// To which side knees and elbows bend: what limits of joints and the poles of controls are made of.
#ifndef SINEW_CHARACTER_MOTION_LIMB_BENDS_HPP
#define SINEW_CHARACTER_MOTION_LIMB_BENDS_HPP

#include <optional>
#include <string>
#include <vector>

#include "motion/upright_body.hpp"
#include "sinew_formats/base/axis.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Directions of a body in the world at rest, unit vectors, and the middle of its hips.
struct BodyFrame {
  Point3 up{}, front{}, left{}, middle{};  // no front: nobody knows
};

// Up from feet to head, front where toes point, else by the sides of names.
//   up  of the world: "x", "y", "z", or "auto"
BodyFrame body_frame(const std::vector<Joint>& joints, const UprightBody& body, MaybeAxis up);

// To where a calf, else a forearm, goes when its joint bends, across the bone above it: to the side of the bend at rest, else the calf back and the
// forearm to the front. nullopt where nobody knows.
//   along, own  unit vectors along the bone above and along its own
//   front       of the body; zero: nobody knows
std::optional<Point3> bend_side(const Point3& along, const Point3& own, const Point3& front, bool calf);

}  // namespace sinew
#endif
