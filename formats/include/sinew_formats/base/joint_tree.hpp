// SPDX-License-Identifier: MIT
// The joint tree: indices of joints, which are int where -1 means none, as positions in arrays.
#ifndef SINEW_FORMATS_BASE_JOINT_TREE_HPP
#define SINEW_FORMATS_BASE_JOINT_TREE_HPP

#include <cstddef>

namespace sinew {

inline size_t joint_index(int joint) { return static_cast<size_t>(joint); }

}  // namespace sinew
#endif
