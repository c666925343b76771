// SPDX-License-Identifier: MIT
// Four soft edges or four hard volumes at once with AVX2.
#include "kernels/constraints.hpp"

#if defined(__AVX2__)
#include "kernels/constraints_s32_256.hpp"

namespace sinew {
bool add_constraints_s32_avx2(ConstraintKernels* kernels) {
  kernels->edges = solve_edges<Constraints256, Constraints256>;
  kernels->volumes = solve_volumes<Constraints256, Constraints256>;
  return true;
}
}  // namespace sinew
#else
namespace sinew {
bool add_constraints_s32_avx2(ConstraintKernels*) { return false; }
}  // namespace sinew
#endif
