// SPDX-License-Identifier: MIT
// Steps of constraints in plain integers: the reference's and the solver's. Kernels for one instruction set have their own
// (kernels/isolated.hpp).
#ifndef SINEW_KERNELS_CONSTRAINT_STEPS_HPP
#define SINEW_KERNELS_CONSTRAINT_STEPS_HPP

#include "core/vector_math.hpp"
#include "kernels/constraints.hpp"

namespace sinew {

inline int32_t clamped(int32_t x, int32_t most) { return x > most ? most : x < -most ? -most : x; }
inline Vec3i clamped(Vec3i v, int32_t most) { return {clamped(v.x, most), clamped(v.y, most), clamped(v.z, most)}; }
inline int32_t rounded(int64_t v, int shift) {
  return static_cast<int32_t>((v + (int64_t{1} << (shift - 1))) >> shift);
}

// A vector of products over the cell's edge.
inline Vec3i over_cell(Vec3l v) {
  return {static_cast<int32_t>(v.x >> kCellBits), static_cast<int32_t>(v.y >> kCellBits),
          static_cast<int32_t>(v.z >> kCellBits)};
}
inline void step(Vec3i* p, int64_t ratio, Vec3i v, int shift) {
  p->x += rounded(ratio * v.x, shift);
  p->y += rounded(ratio * v.y, shift);
  p->z += rounded(ratio * v.z, shift);
}

}  // namespace sinew
#endif
