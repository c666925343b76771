// SPDX-License-Identifier: MIT
// What linear skinning lacks in a set of poses.
#ifndef SINEW_DATASETS_BAKE_CORRECTIONS_HPP
#define SINEW_DATASETS_BAKE_CORRECTIONS_HPP

#include <vector>

#include "sinew_datasets/bake.hpp"

namespace sinew {

// Corrected minus linearly skinned, [poses][3 V].
struct Corrections {
  std::vector<std::vector<float>> lacks;
  size_t pose_count() const { return lacks.size(); }
};

Corrections find_corrections(const Character& character, const std::vector<Palette>& poses,
                             const sinew_deform_options& deform, const BakeProgress& progress);

}  // namespace sinew
#endif
