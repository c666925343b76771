// SPDX-License-Identifier: MIT
// A fitted skeleton without limbs beside the mesh.
#ifndef SINEW_CHARACTER_PREDICT_KEEP_INSIDE_HPP
#define SINEW_CHARACTER_PREDICT_KEEP_INSIDE_HPP

#include <cstddef>

#include "sinew_character/predict/fit_skeleton.hpp"

namespace sinew {

// Bones of chains that nothing of the mesh spoke for (FitHow::kCarried) become so short, by tenths to a tenth, that they end in it or within
// 2 % of its longest side from a vertex; both of a mirrored pair alike. What matched joints hang on stays. Returns how many bones became
// shorter.
size_t keep_inside(const Character& mesh, FittedSkeleton* fitted);

}  // namespace sinew
#endif
