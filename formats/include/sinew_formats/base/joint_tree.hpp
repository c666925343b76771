// SPDX-License-Identifier: MIT
// Parents and children of joints.
#ifndef SINEW_FORMATS_BASE_JOINT_TREE_HPP
#define SINEW_FORMATS_BASE_JOINT_TREE_HPP

#include <cstddef>
#include <vector>

namespace sinew {

// Converts a joint index, an int where -1 means none, to an array index.
inline size_t joint_index(int joint) { return static_cast<size_t>(joint); }

// Takes joints with a member `parent`: the index of another joint, or negative for a root.
struct JointTree {
  JointTree() = default;
  template <class Joints>
  explicit JointTree(const Joints& joints) : children(joints.size()) {
    for (size_t j = 0; j < joints.size(); ++j) {
      const int parent = joints[j].parent;
      if (parent < 0)
        parents_first.push_back(j);
      else if (joint_index(parent) < joints.size())
        children[joint_index(parent)].push_back(static_cast<int>(j));
    }
    for (size_t next = 0; next < parents_first.size(); ++next)
      for (const int child : children[parents_first[next]]) parents_first.push_back(joint_index(child));
  }

  std::vector<std::vector<int>> children;  // [J], ascending
  std::vector<size_t> parents_first;       // level by level, without joints that are in a cycle
};

}  // namespace sinew
#endif
