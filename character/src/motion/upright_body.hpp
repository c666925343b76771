// SPDX-License-Identifier: MIT
// Two legs, two arms and a torso among the joints of a skeleton, and whether they stand.
#ifndef SINEW_CHARACTER_MOTION_UPRIGHT_BODY_HPP
#define SINEW_CHARACTER_MOTION_UPRIGHT_BODY_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Joints of an arm or a leg; -1 where there is none.
struct UprightLimb {
  int upper = -1, middle = -1, end = -1;  // shoulder or hip, elbow or knee, hand or foot
  int tip = -1;                           // a joint beyond the end, such as the toes
};

// Left first, where `sided`.
struct UprightBody {
  std::array<UprightLimb, 2> legs, arms;
  bool has_arms = false;
  int hips = -1, chest = -1;  // where legs meet, where arms meet; without arms the head's parent
  int head = -1;
  bool sided = false;  // left and right come from names
};

// All of them: legs (thigh, calf, foot), or arms (upper arm, forearm, hand), in the order of their first joints. By classes [J]
// (sinew_joint_class).
std::vector<UprightLimb> find_limbs(const std::vector<Joint>& joints, const std::vector<uint8_t>& classes, bool legs);

// By classes [J] (sinew_joint_class); nullopt without two legs below one joint, or without a head or arms above it.
std::optional<UprightBody> find_upright_body(const std::vector<Joint>& joints, const std::vector<uint8_t>& classes);

// Returns whether a body is standing in a pose: legs below it, head above, left and right apart and mirrored.
bool is_upright(const UprightBody& body, const std::vector<Point3>& positions);

// Directions of a body in the world at rest, unit vectors, and the middle of its hips.
struct BodyFrame {
  Point3 up{}, front{}, left{}, middle{};  // zero front: unknown
};

// Up from feet to head, front where toes point, else by the sides of names.
//   up  of the world: "x", "y", "z", or "auto"
BodyFrame body_frame(const std::vector<Joint>& joints, const UprightBody& body, MaybeAxis up);

// The direction in which a calf, else a forearm, moves when its joint bends, across the bone above it: to the side of
// the bend at rest, else the calf back and the forearm to the front. Returns nullopt if unknown.
//   along, own  unit vectors along the bone above and along its own
//   front       of the body; zero: unknown
std::optional<Point3> bend_side(const Point3& along, const Point3& own, const Point3& front, bool calf);

}  // namespace sinew
#endif
