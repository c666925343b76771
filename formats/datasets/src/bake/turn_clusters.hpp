// SPDX-License-Identifier: MIT
// Representative turns among many.
#ifndef SINEW_DATASETS_BAKE_TURN_CLUSTERS_HPP
#define SINEW_DATASETS_BAKE_TURN_CLUSTERS_HPP

#include <vector>

#include "sinew_formats/motion.hpp"

namespace sinew {

// At most `count` turns, means of clusters (Lloyd) that start at turns far from each other and from none. No two are the same.
std::vector<Quaternion> turn_clusters(const std::vector<Quaternion>& turns, size_t count);

}  // namespace sinew
#endif
