// SPDX-License-Identifier: MIT
// What linear skinning lacks in a set of poses, as moves before it.
#ifndef SINEW_CHARACTER_BAKE_CORRECTIONS_HPP
#define SINEW_CHARACTER_BAKE_CORRECTIONS_HPP

#include <Eigen/Core>

#include "sinew_character/bake/bake.hpp"

namespace sinew {

// [poses x 3 V] where each vertex would have to stand at rest, less where it does: least squares against the corrected pose, with
// a small ridge where skinning flattens.
Eigen::MatrixXf moves_before_skinning(const Character& character, const std::vector<Palette>& poses,
                                      const sinew_deform_options& deform, const BakeProgress& progress);

}  // namespace sinew
#endif
