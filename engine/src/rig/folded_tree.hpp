// SPDX-License-Identifier: MIT
// Folded joints to a tree: who is whose parent by the votes of the points between them, and where bones end. Without votes,
// the skeleton that a mesh's shape has by itself: its middle line, for meshes that no model knows.
#ifndef SINEW_RIG_FOLDED_TREE_HPP
#define SINEW_RIG_FOLDED_TREE_HPP

#include "rig/clusters.hpp"
#include "votes/body_kind.hpp"
#include "votes/interior.hpp"

namespace sinew::rigging {

struct FoldedNode {
  Vec3i at = {0, 0, 0};
  int16_t parent = -1;
  uint8_t joint_class = kClassPelvis;
  int8_t side = 0;  // 1 left, -1 right, 0: its position says
  int8_t only =
      0;  // of a joint beside the plane of a mirrored tree: 1 has no image at -x, -1 is the image alone, 0 is both
  bool has_end = false;
  uint16_t confidence = 0;         // Q15: mean trust in the votes for the joint, 0 where there are none
  uint16_t parent_confidence = 0;  // Q15: exp(-cost of the connection); the root's is 1
  uint16_t end_confidence = 0;     // Q15
  Vec3i end = {0, 0, 0};           // of the bone, where no joint is
};

// A node with x > 0 of a mirrored tree represents two, or for one where the body has it on one side only. No node on
// the plane has a parent beside it, so what represents two has a mirror image to stand on.
struct FoldedTree {
  bool mirrored = false;
  uint32_t count = 0;
  uint32_t root = 0;
  FoldedNode nodes[kMaxFoldedJoints];

  bool beside(uint32_t node) const { return mirrored && nodes[node].at.x > 0; }
  int8_t only(uint32_t node) const { return beside(node) ? nodes[node].only : int8_t{0}; }
};

// Every point belongs to the joint of its start vote and, where its end is not a tip, votes for a connection from there
// to the joint of its end vote. The root is the heaviest pelvis on the plane, else the joint nearest to the points'
// mean; where no joint is on the plane it is put there. Prim's algorithm takes one more joint at a time at the least
// cost: surprise in the votes, the path through the body (rig/body_ways.hpp), surprise in the two classes. A limb is
// a chain of its own: joints of paired classes on opposite sides are never connected, nor is an arm or a leg to a
// tail or an ear, nor an ear on them; what goes on from a joint of a limb that has its next already costs more
// (rig/limbs.hpp). Ends are modes of the end votes that are tips. A childless joint without an end that lies on a bone
// of its limb divides that bone.
//   joints  in   [count], count >= 1, as from find_folded_joints()
//   kind         of body: its limbs are arms or legs by where they are (rig/limbs.hpp), and the tree is grown by that
//   interior     of the mesh, or null: paths are straight then, and nothing is covered. Its distances are overwritten
//   tree    out  nodes have the joints' numbers; chains of coverage.hpp come after them
//   arena        scratch, all of it released
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status grow_tree(const VotePool& pool, const FoldedJoint* joints, uint32_t count, BodyKind kind,
                       Interior* interior, Arena& arena, FoldedTree* tree);

// The solid cells are split into bands by their distance from the body's middle, and bands into connected regions
// (level sets of the distance: Verroust and Lazarus 2000). The parent of a region is the one through which it is
// reached. Branches that are short go; joints stand where branches begin, meet and bend, and where a bone would be
// too long; leaves become bone ends. All joints are of class other, and no vote speaks for them: their confidence is
// 0.
//   folded  the mesh is its own mirror image: only x >= 0 is used; what touches the plane lies on it
//   tree    out   at least one node, the root
//   arena         scratch, all of it released
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status grow_curve(const Interior& interior, bool folded, Arena& arena, FoldedTree* tree);

}  // namespace sinew::rigging
#endif
