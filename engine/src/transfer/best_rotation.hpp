// SPDX-License-Identifier: MIT
// The rotation that fits vectors best, and the smallest one between two.
#ifndef SINEW_TRANSFER_BEST_ROTATION_HPP
#define SINEW_TRANSFER_BEST_ROTATION_HPP

#include "transfer/real.hpp"

namespace sinew::transferring {

// The rotation R that makes the sum of v . (R u) largest (Horn 1987).
//   sums  row-major sum of v u^T
//   gap   out, when not null: by how much the best is better than the second, 0..1; near 0 the vectors lie on a line
Mat3 best_rotation(const Mat3& sums, double* gap);
// The smallest rotation that turns u to v's direction; any about a half turn.
Mat3 rotation_between(Vec3d u, Vec3d v);

}  // namespace sinew::transferring
#endif
