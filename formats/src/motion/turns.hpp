// SPDX-License-Identifier: MIT
// Quaternions of clips and the other forms of a rotation that files use.
#ifndef SINEW_FORMATS_MOTION_TURNS_HPP
#define SINEW_FORMATS_MOTION_TURNS_HPP

#include "sinew_formats/motion.hpp"

namespace sinew {

// a after b.
Quaternion multiply(const Quaternion& a, const Quaternion& b);
inline Quaternion conjugate(const Quaternion& q) { return {-q[0], -q[1], -q[2], q[3]}; }
double dot(const Quaternion& a, const Quaternion& b);
// kNoRotation4 for one without length.
Quaternion normalised(const Quaternion& q);
Point3 rotate(const Quaternion& q, const Point3& v);
// About axis 0, 1 or 2.
Quaternion axis_rotation(size_t axis, double radians);
// Along the shortest arc; t from 0 to 1.
Quaternion slerp(const Quaternion& a, Quaternion b, double t);
Rotation rotation_of(const Quaternion& q);
Quaternion quaternion_of(const Rotation& r);
// The rotation in an affine transform that scales, perhaps mirrors: columns made orthogonal in their order.
Rotation rotation_part(const Affine& m);

}  // namespace sinew
#endif
