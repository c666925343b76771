// SPDX-License-Identifier: MIT
// A skeleton from the pieces that a surface falls into: the published way, for comparison with the middle line (curve.hpp).
#ifndef SINEW_RIG_REGIONS_HPP
#define SINEW_RIG_REGIONS_HPP

#include "mesh/mesh.hpp"
#include "rig/folded_tree.hpp"

namespace sinew::rigging {

// Seeds as far from each other as can be; regions that grow from them over edges; an oriented box around each. Regions whose
// boxes overlap and whose points come near each other are joined in a graph of the boxes' middles. Its edges collapse, the
// cheapest first (simplify/collapse_cost.hpp): those of triangles, whose ends share a neighbour, those of regions without much surface, short ones,
// leaves of a crowd. What is left is joined by its shortest tree from the node nearest to the middle of the surface.
// All joints are of class other, their confidence is 0, and nothing is mirrored.
//   tree  out  at least one node, the root
// Scratch is taken from the arena and released. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status grow_regions(const Mesh& mesh, const Counts& counts, Arena& arena, FoldedTree* tree);

}  // namespace sinew::rigging
#endif
