// SPDX-License-Identifier: MIT
// The stages from votes to joints, and the tree unfolded.
#include "rig/tree.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

class Unfolder {
 public:
  Unfolder(const FoldedTree& tree, bool ends, Rig* rig) : tree_(tree), ends_(ends), rig_(*rig) {}

  SINEW_RARE void run() {
    rig_.count = 0;
    for (int16_t& joint : joints_) joint = -1;
    sort_nodes();
    uint32_t stack[2 * kMaxFoldedJoints], depth = 0;  // twice a node, and 1 for its image
    stack[depth++] = 2 * tree_.root;
    while (depth > 0) {
      const uint32_t next = stack[--depth], node = next / 2, side = next % 2;
      add_node(node, side);
      // The last to be pushed is the first to come.
      for (uint32_t i = tree_.count; i-- > 0;) {
        const uint32_t child = order_[i];
        if (tree_.nodes[child].parent != static_cast<int16_t>(node)) continue;
        const bool splits = tree_.beside(child) && !tree_.beside(node);
        const int8_t only = tree_.only(child);
        if ((splits || side == 1) && only <= 0) stack[depth++] = 2 * child + 1;
        if ((splits || side == 0) && only >= 0) stack[depth++] = 2 * child;
      }
    }
    for (uint32_t i = 0; i < 4 * tree_.count && tree_.mirrored; ++i) {
      if (joints_[i] < 0) continue;
      const bool alone = tree_.only(i / 4) != 0;
      rig_.joints[joints_[i]].partner = joints_[i ^ 1] >= 0 ? joints_[i ^ 1] : alone ? int16_t{-1} : joints_[i];
    }
  }

 private:
  void sort_nodes() {
    for (uint32_t i = 0; i < tree_.count; ++i) {
      uint32_t at = i;
      for (; at > 0 && tree_.nodes[order_[at - 1]].joint_class > tree_.nodes[i].joint_class; --at) {
        order_[at] = order_[at - 1];
      }
      order_[at] = i;
    }
  }

  // Four numbers a node: itself, its image, its end, its end's image.
  SINEW_RARE void add(uint32_t number, Vec3i at, RigJoint joint) {
    joint.position = (number & 1) != 0 ? Vec3i{-at.x, at.y, at.z} : at;
    joints_[number] = static_cast<int16_t>(rig_.count);
    rig_.joints[rig_.count++] = joint;
  }

  SINEW_RARE void add_node(uint32_t number, uint32_t side) {
    const FoldedNode& node = tree_.nodes[number];
    RigJoint joint = {node.at, -1, -1, node.joint_class, 0, node.confidence, node.parent_confidence, node.side};
    if (node.parent >= 0) {
      const uint32_t above = static_cast<uint32_t>(node.parent);
      joint.parent = joints_[4 * above + (tree_.beside(above) ? side : 0)];
    }
    add(4 * number + side, node.at, joint);
    if (!ends_ || !node.has_end) return;
    joint.parent = joints_[4 * number + side];
    joint.tip = 1;
    joint.confidence = node.end_confidence;
    joint.parent_confidence = 32768;
    add(4 * number + 2 + side, node.end, joint);
    // An end beside the plane of a joint on it comes twice.
    if (tree_.mirrored && !tree_.beside(number) && node.end.x != 0) add(4 * number + 3, node.end, joint);
  }

  const FoldedTree& tree_;
  const bool ends_;
  Rig& rig_;
  uint32_t order_[kMaxFoldedJoints];      // nodes by class
  int16_t joints_[4 * kMaxFoldedJoints];  // of the skeleton, -1 where there is none
};

uint16_t mean_spread(const Votes& votes) {
  if (votes.points == 0) return 65535;
  int64_t sum = 0;
  for (uint32_t i = 0; i < votes.points; ++i) sum += log2_q16(votes.start_spread[i]) + log2_q16(votes.end_spread[i]);
  const int64_t spread = exp2_negative((16 << 16) - sum / (2 * int64_t{votes.points})) >> 14;
  return static_cast<uint16_t>(spread > 65535 ? 65535 : spread);
}

// Legs stand on a pelvis: where no joint was voted for as one, the spine joint that carries both legs is it.
void find_pelvis(FoldedTree* tree) {
  uint8_t legs[kMaxFoldedJoints] = {};
  for (uint32_t i = 0; i < tree->count; ++i) {
    const FoldedNode& node = tree->nodes[i];
    if (node.joint_class == kClassPelvis) return;
    const bool leg = node.joint_class == kClassThigh || node.joint_class == kClassHip;
    if (leg && node.parent >= 0)
      legs[node.parent] = static_cast<uint8_t>(legs[node.parent] + (tree->beside(i) && node.only == 0 ? 2 : 1));
  }
  for (uint32_t i = 0; i < tree->count; ++i) {
    if (legs[i] < 2 || tree->nodes[i].joint_class != kClassSpine) continue;
    tree->nodes[i].joint_class = kClassPelvis;
    return;
  }
}

}  // namespace

bool Rig::allocate(Arena& arena) {
  joints = arena.alloc<RigJoint>(kMaxRigJoints);
  return arena.ok();
}

SINEW_RARE sinew_status find_rig(const Votes& votes, const RigOptions& options, Interior* interior, Arena& arena,
                                 Rig* rig) {
  const ArenaScope scope(arena);
  VotePool pool;
  const bool fits = pool.build(votes, votes.folded && options.fold, arena);
  FoldedJoint* const joints = arena.alloc<FoldedJoint>(kMaxFoldedJoints);
  FoldedTree* const tree = arena.alloc<FoldedTree>(1);
  if (!fits || !arena.ok()) return SINEW_ERROR_WORKSPACE;
  uint32_t count = 0;
  sinew_status status = find_folded_joints(pool, arena, joints, &count);
  if (status != SINEW_OK) return status;
  if (!arena.measuring() && count == 0) {
    joints[0] = {votes.mean, kClassPelvis, 0};
    count = 1;
  }
  status = grow_tree(pool, joints, count, options.kind, interior, arena, tree);
  if (status != SINEW_OK || arena.measuring()) return status;
  settle_stubs(tree);
  unfold_tree(options, tree, rig);
  rig->spread = mean_spread(votes);
  return SINEW_OK;
}

SINEW_RARE void unfold_tree(const RigOptions& options, FoldedTree* tree, Rig* rig) {
  find_pelvis(tree);
  if (options.spine >= 0)
    set_spine(tree,
              static_cast<uint32_t>(options.spine) < kMaxSpine ? static_cast<uint32_t>(options.spine) : kMaxSpine);
  if (!options.toes) drop_toes(tree);
  Unfolder(*tree, options.ends, rig).run();
}

}  // namespace sinew::rigging
