// SPDX-License-Identifier: MIT
// The skeleton that a mesh's shape has by itself: its middle line, for meshes that no model knows.
#ifndef SINEW_RIG_CURVE_HPP
#define SINEW_RIG_CURVE_HPP

#include "rig/folded_tree.hpp"
#include "votes/interior.hpp"

namespace sinew::rigging {

// The solid cells fall into bands by their way from the body's middle, and bands into regions that hang together (level
// sets of the distance: Verroust and Lazarus 2000). A region hangs on the one through which it is reached. Branches that are short
// go; joints stand where branches begin, meet and bend, and where a bone would be too long; leaves become bone ends.
// All joints are of class other, and no vote speaks for them: their confidence is 0.
//   folded  the mesh is its own mirror image: only what lies at x >= 0 is looked at, what touches the plane lies on it
//   tree    out   at least one node, the root
//   arena         scratch, all of it released
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status grow_curve(const Interior& interior, bool folded, Arena& arena, FoldedTree* tree);

}  // namespace sinew::rigging
#endif
