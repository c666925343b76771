// SPDX-License-Identifier: MIT
// A standing person's joints for motions that bring none: names, hierarchy and positions.
#ifndef SINEW_FORMATS_MOTION_PERSON_HPP
#define SINEW_FORMATS_MOTION_PERSON_HPP

#include <string>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// VRM's names. In a T pose, 1.7 m high, y up, facing +z, left at +x; a joint's parent is the nearest of its ancestors that is listed.
// Positions are our own (the bundled skeleton of character, to the centimeter), of no body model.
std::vector<MotionJoint> person_joints(const std::vector<std::string>& names);

// Exchanges "left" and "right"; returns the same name if it has no side.
std::string other_side_of_person(const std::string& name);

// -1 for none.
int joint_named(const std::vector<MotionJoint>& joints, const std::string& name);

// Height of the lowest joint at rest, 0 where none lies below the origin.
double lowest_at_rest(const Motion& motion);

// The rotation, by multiples of 90 degrees, of the axis nearest to `up` onto y.
Quaternion turn_to_y_up(const Point3& up);
// "y", "-z" of the nearest axis, for the user.
std::string axis_name(const Point3& direction);

}  // namespace sinew
#endif
