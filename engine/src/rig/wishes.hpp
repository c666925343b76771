// SPDX-License-Identifier: MIT
// What a caller wants of a skeleton whatever the votes say: so many spine joints, no toes.
#ifndef SINEW_RIG_WISHES_HPP
#define SINEW_RIG_WISHES_HPP

#include "rig/folded_tree.hpp"

namespace sinew::rigging {

constexpr uint32_t kMaxSpine = 16;

// Replaces the spine joints between the pelvis and the neck or head by `joints` <= kMaxSpine at equal steps: from the
// first to the last that there were, or, where there were less than two, between the joints below and above. Without
// neck and head it is the longest chain of spine joints. What hung on one that goes hangs on the nearest. A root is no
// part of the chain, whatever its class. Fewer are made where the tree would be full; nothing is done where there is no
// such chain.
void set_spine(FoldedTree* tree, uint32_t joints);

// Takes toe joints away, but for a root. A foot that is a leaf now ends where its heaviest toe was; what else hung on a
// toe hangs on the foot.
void drop_toes(FoldedTree* tree);

}  // namespace sinew::rigging
#endif
