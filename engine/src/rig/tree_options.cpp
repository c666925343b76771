// SPDX-License-Identifier: MIT
// Chains of the spine cut and placed anew; stubs settled; toes cut off.
#include "core/vector_math.hpp"
#include "rig/tree.hpp"

namespace sinew::rigging {
namespace {

constexpr int16_t kNoNode = -1;

bool is_class(const FoldedTree& tree, int16_t node, uint32_t c) {
  return node >= 0 && tree.nodes[node].joint_class == c;
}

bool is_crown(const FoldedTree& tree, int16_t node) {
  return is_class(tree, node, kClassNeck) || is_class(tree, node, kClassHead);
}

// A chain of the spine from below to above, and what it stands between.
struct Spine {
  int16_t below = kNoNode, above = kNoNode;  // `above` only where the chain has a neck or head on it
  uint32_t count = 0;
  int16_t nodes[kMaxFoldedJoints];
};

// The spine joints right below a node, the root left out.
SINEW_RARE Spine spine_below(const FoldedTree& tree, int16_t top) {
  Spine spine;
  int16_t at = top;
  for (; is_class(tree, at, kClassSpine) && at != static_cast<int16_t>(tree.root); at = tree.nodes[at].parent) {
    spine.nodes[spine.count++] = at;
  }
  for (uint32_t i = 0; 2 * i + 1 < spine.count; ++i) {
    const int16_t other = spine.nodes[spine.count - 1 - i];
    spine.nodes[spine.count - 1 - i] = spine.nodes[i];
    spine.nodes[i] = other;
  }
  spine.below = at;
  return spine;
}

SINEW_RARE Spine find_spine(const FoldedTree& tree) {
  Spine best;
  for (uint32_t j = 0; j < tree.count; ++j) {
    const int16_t node = static_cast<int16_t>(j);
    if (tree.beside(j) || !is_crown(tree, node) || tree.nodes[j].parent < 0) continue;
    if (is_crown(tree, tree.nodes[j].parent)) continue;
    Spine spine = spine_below(tree, tree.nodes[j].parent);
    spine.above = node;
    if (best.above == kNoNode || spine.count > best.count) best = spine;
  }
  if (best.above != kNoNode) return best;
  for (uint32_t j = 0; j < tree.count; ++j) {
    if (tree.beside(j)) continue;
    const Spine spine = spine_below(tree, static_cast<int16_t>(j));
    if (spine.count > best.count) best = spine;
  }
  return best;
}

// Where nodes are along a line of them.
struct Line {
  uint32_t count = 0;
  Vec3i at[kMaxFoldedJoints + 2];
  int64_t along[kMaxFoldedJoints + 2];  // from the first, grid units

  void add(Vec3i p) {
    along[count] = count == 0 ? 0 : along[count - 1] + static_cast<int64_t>(length(p - at[count - 1]));
    at[count++] = p;
  }
  Vec3i position(int64_t distance) const {
    uint32_t i = 1;
    while (i + 1 < count && along[i] < distance) ++i;
    const int64_t whole = along[i] - along[i - 1], share = distance - along[i - 1];
    if (whole == 0) return at[i];
    const Vec3i step = at[i] - at[i - 1];
    return at[i - 1] + round_div(Vec3l{step.x * share, step.y * share, step.z * share}, whole);
  }
};

uint32_t nearest(const int64_t* distances, uint32_t count, int64_t distance) {
  uint32_t best = 0;
  for (uint32_t i = 1; i < count; ++i) {
    if (abs64(distances[i] - distance) < abs64(distances[best] - distance)) best = i;
  }
  return best;
}

// Removes leaves, never the root; numbers [count] get the new index of each remaining node.
SINEW_RARE void remove(const bool* gone, FoldedTree* tree, int16_t* numbers) {
  uint32_t kept = 0;
  for (uint32_t j = 0; j < tree->count; ++j) {
    numbers[j] = static_cast<int16_t>(kept);
    if (!gone[j]) tree->nodes[kept++] = tree->nodes[j];
  }
  tree->count = kept;
  tree->root = static_cast<uint32_t>(numbers[tree->root]);
  for (uint32_t j = 0; j < kept; ++j) {
    if (tree->nodes[j].parent >= 0) tree->nodes[j].parent = numbers[tree->nodes[j].parent];
  }
}

}  // namespace

SINEW_RARE void set_spine(FoldedTree* tree, uint32_t joints) {
  const Spine old = find_spine(*tree);
  if (old.below == kNoNode || (old.above == kNoNode && old.count == 0)) return;
  const uint32_t room = kMaxFoldedJoints - tree->count + old.count;
  const uint32_t count = joints < room ? joints : room;

  Line line;
  line.add(tree->nodes[old.below].at);
  for (uint32_t i = 0; i < old.count; ++i) line.add(tree->nodes[old.nodes[i]].at);
  if (old.above != kNoNode) line.add(tree->nodes[old.above].at);
  // From `first` on, at `count` positions with `gaps` steps between them.
  int64_t first = 0, last = line.along[line.count - 1], gaps = int64_t{count} + 1, skipped = 1;
  if (old.count >= 2) {
    first = line.along[1];
    last = line.along[old.count];
    gaps = count == 1 ? 2 : int64_t{count} - 1;
    skipped = count == 1 ? 1 : 0;
  } else if (old.above == kNoNode) {
    gaps = count;  // the last stays at the chain's end
  }
  FoldedNode made[kMaxSpine];
  int64_t distances[kMaxSpine];
  for (uint32_t i = 0; i < count; ++i) {
    distances[i] = first + round_div((last - first) * (i + skipped), gaps);
    if (old.count > 0) made[i] = tree->nodes[old.nodes[nearest(line.along + 1, old.count, distances[i])]];
    made[i].at = line.position(distances[i]);
    made[i].joint_class = kClassSpine;
    made[i].has_end = made[i].has_end && i + 1 == count;
  }
  // Children of the old chain: parent i of the new one is -2 - i until it has a number.
  bool gone[kMaxFoldedJoints] = {};
  for (uint32_t i = 0; i < old.count; ++i) gone[old.nodes[i]] = true;
  for (uint32_t j = 0; j < tree->count; ++j) {
    uint32_t i = 0;
    while (i < old.count && tree->nodes[j].parent != old.nodes[i]) ++i;
    if (i == old.count || gone[j]) continue;
    tree->nodes[j].parent =
        count == 0 ? old.below
                   : static_cast<int16_t>(-2 - static_cast<int>(nearest(distances, count, line.along[1 + i])));
  }
  if (old.above != kNoNode) {
    tree->nodes[old.above].parent = count == 0 ? old.below : static_cast<int16_t>(-1 - static_cast<int>(count));
  }
  int16_t numbers[kMaxFoldedJoints] = {};
  remove(gone, tree, numbers);
  for (uint32_t j = 0; j < tree->count; ++j) {
    if (tree->nodes[j].parent < -1) {
      tree->nodes[j].parent = static_cast<int16_t>(static_cast<int>(tree->count) - 2 - tree->nodes[j].parent);
    }
  }
  for (uint32_t i = 0; i < count; ++i) {
    made[i].parent = i == 0 ? numbers[old.below] : static_cast<int16_t>(tree->count - 1);
    tree->nodes[tree->count++] = made[i];
  }
}

SINEW_RARE void settle_stubs(FoldedTree* tree) {
  bool gone[kMaxFoldedJoints] = {};
  for (uint32_t j = 0; j < tree->count; ++j) {
    const FoldedNode& node = tree->nodes[j];
    gone[j] =
        (node.joint_class == kClassClavicle || node.joint_class == kClassHip) && !node.has_end && node.parent >= 0;
  }
  for (uint32_t j = 0; j < tree->count; ++j)
    if (tree->nodes[j].parent >= 0) gone[tree->nodes[j].parent] = false;
  for (uint32_t j = 0; j < tree->count; ++j) {
    FoldedNode& node = tree->nodes[j];
    for (uint32_t k = 0; k < tree->count && gone[j]; ++k) {
      FoldedNode& next = tree->nodes[k];
      if (next.joint_class != node.joint_class + 1 || next.parent < 0 || tree->beside(k) != tree->beside(j) ||
          tree->only(k) != tree->only(j) || next.side != node.side)
        continue;
      const FoldedNode& trunk = tree->nodes[next.parent];
      if (limb_of(trunk.joint_class) != LimbClass::kNone ||
          square_distance(trunk.at, node.at) > square_distance(trunk.at, next.at))
        continue;
      node.parent = next.parent;
      next.parent = static_cast<int16_t>(j);
      gone[j] = false;
    }
  }
  int16_t numbers[kMaxFoldedJoints] = {};
  remove(gone, tree, numbers);
}

SINEW_RARE void drop_toes(FoldedTree* tree) {
  bool gone[kMaxFoldedJoints] = {}, leaf[kMaxFoldedJoints] = {};
  for (uint32_t j = 0; j < tree->count; ++j) {
    leaf[j] = true;
    gone[j] = tree->nodes[j].joint_class == kClassToe && j != tree->root;
  }
  int16_t holders[kMaxFoldedJoints];  // who is no toe
  for (uint32_t j = 0; j < tree->count; ++j) {
    int16_t holder = tree->nodes[j].parent;
    while (holder >= 0 && gone[holder]) holder = tree->nodes[holder].parent;
    holders[j] = holder;
    if (holder >= 0 && !gone[j]) leaf[holder] = false;
  }
  for (uint32_t j = tree->count; j-- > 0;) {
    if (!gone[j]) continue;
    FoldedNode& foot = tree->nodes[holders[j]];
    if (tree->nodes[j].parent != holders[j] || !leaf[holders[j]]) continue;
    foot.has_end = true;
    foot.end = tree->nodes[j].at;
    foot.end_confidence = tree->nodes[j].confidence;
  }
  for (uint32_t j = 0; j < tree->count; ++j) tree->nodes[j].parent = holders[j];
  int16_t numbers[kMaxFoldedJoints] = {};
  remove(gone, tree, numbers);
}

}  // namespace sinew::rigging
